"""Says how many tests ran, and fails where one was skipped that should have run, or where there are fewer tests than before.

Usage: check_results.py EXPECTED.json BUILD RESULTS.xml ...

RESULTS are what `ctest --output-junit` or a test program with `--gtest_output=xml` wrote; what ctest says of a program whose own
file is among them counts only where it failed. EXPECTED has for each BUILD ("release", "asan", "asan-light", "asan-all", "thorough") the number of tests that
there must be at least, and the skips that are no surprise: a pattern of whole test names, what the test must have printed,
the condition of the machine under which it may be skipped, the builds in which it may (all, where none is named), and the
reason. Exits with 1 where something is not as expected.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree


def may_mount():
    """Whether this process has CAP_SYS_ADMIN."""
    status = pathlib.Path("/proc/self/status").read_text(encoding="utf-8")
    capabilities = re.search(r"^CapEff:\s*([0-9a-f]+)", status, re.MULTILINE)
    return capabilities is not None and int(capabilities.group(1), 16) >> 21 & 1 == 1


def has_r():
    """Whether there is R with the packages of analysis.R."""
    question = 'q(status = !all(sapply(c("lme4", "lmerTest", "survival"), requireNamespace, quietly = TRUE)))'
    program = shutil.which("Rscript")
    return program is not None and subprocess.run([program, "-e", question], capture_output=True, check=False).returncode == 0


CONDITIONS = {
    "always": lambda: True,
    "no meshes": lambda: "OCELLI_DATA_DIR" not in os.environ,
    "root": lambda: os.geteuid() == 0,
    "no right to mount": lambda: not may_mount(),
    "no mkdocs": lambda: not pathlib.Path("/usr/bin/mkdocs").exists(),
    "no Doxygen": lambda: shutil.which("doxygen") is None,
    "no R": lambda: not has_r(),
    "no opencv-doc": lambda: not pathlib.Path("/usr/share/doc/opencv-doc/examples/data").exists(),
    "no oslc": lambda: shutil.which("oslc") is None,
    "gpu": lambda: any(pathlib.Path("/dev").glob("nvidia[0-9]*")) or any(pathlib.Path("/dev").glob("dri/renderD*")),
}


def outcome_in_program(case):
    """The same of a case in what a test program wrote itself."""
    told = [part.get("message") or part.text or "" for part in case if part.tag in ("failure", "skipped")]
    if case.find("failure") is not None:
        outcome = "failed"
    else:
        outcome = "ran" if case.get("result") == "completed" else "skipped"
    return f"{case.get('classname')}.{case.get('name')}", outcome, "\n".join(told)


def outcomes(path):
    """(name, "ran" | "failed" | "skipped", what it printed) of each test of a file."""
    for case in ElementTree.parse(path).iter("testcase"):
        if case.get("result") is not None:
            yield outcome_in_program(case)
            continue
        printed = "".join(part.text or "" for part in case.iter("system-out"))
        if case.get("status") == "run":
            outcome = "ran"
        elif case.get("status") == "fail" or "Unable to find executable" in printed:
            outcome = "failed"
        else:
            outcome = "skipped"
        yield case.get("name"), outcome, printed


def all_outcomes(paths):
    """Those of all files, each test once: programs that told of their own cases do not count beside them, but where they failed."""
    programs = {pathlib.Path(path).stem for path in paths}
    for path in paths:
        for name, outcome, printed in outcomes(path):
            if name not in programs or outcome == "failed":
                yield name, outcome, printed


def reason_of_skip(name, printed, build, skips, conditions):
    """Why this skip is no surprise; None where it is one."""
    for skip in skips:
        if (
            build in skip.get("builds", [build])
            and re.fullmatch(skip["tests"], name)
            and re.search(skip.get("prints", ""), printed)
            and conditions[skip["if"]]()
        ):
            return skip["reason"]
    return None


def last_line_of_skip(printed):
    lines = [line.strip() for line in printed.splitlines() if line.strip()]
    wanted = [line for line in lines if "Skipped" in line or "skip" in line.lower()]
    return (lines[lines.index(wanted[0]) + 1] if wanted and wanted[0] != lines[-1] else lines[-1]) if lines else ""


def check(expected, build, results, conditions=CONDITIONS):
    """The lines to print, and whether all is as expected. `results` are outcomes()."""
    results = list(results)
    ran = sum(outcome == "ran" for _, outcome, _ in results)
    failed = [name for name, outcome, _ in results if outcome == "failed"]
    reasons = {}
    surprises = []
    for name, outcome, printed in results:
        if outcome == "skipped":
            reason = reason_of_skip(name, printed, build, expected["skips"], conditions)
            if reason:
                reasons[reason] = reasons.get(reason, 0) + 1
            else:
                surprises.append((name, last_line_of_skip(printed)))
    lines = [f"Tests of {build}: {ran} passed, {len(failed)} failed, {sum(reasons.values()) + len(surprises)} skipped."]
    lines += [f"  skipped, as expected: {count} ({reason})" for reason, count in sorted(reasons.items())]
    lines += [f"  FAILED: {name}" for name in failed]
    lines += [
        f"  SKIPPED, and should have run: {name}: {why}\n"
        "    Install what it lacks, or add it to tests/expected_results.json with the reason."
        for name, why in surprises
    ]
    least = expected["least_tests"][build]
    missing = least - len(results)
    if missing > 0:
        lines.append(
            f"  MISSING: there are {len(results)} tests, and there were {least}. "
            "If tests were removed on purpose, say so in tests/expected_results.json."
        )
    elif missing < 0:
        lines.append(f"  {-missing} more than tests/expected_results.json knows: raise least_tests.{build} to {len(results)}.")
    return lines, not failed and not surprises and missing <= 0


def main(arguments):
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    expected = json.loads(pathlib.Path(arguments[0]).read_text(encoding="utf-8"))
    lines, good = check(expected, arguments[1], all_outcomes(arguments[2:]))
    print("\n".join(lines))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
