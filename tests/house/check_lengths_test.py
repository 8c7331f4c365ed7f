"""check_lengths.py finds what is too long."""

import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import check_lengths  # noqa: E402


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "oc_core").mkdir()
        (root / "oc_core" / "just.cpp").write_text("//\n" * check_lengths.MAX_LINES)
        assert check_lengths.long_files(root) == []
        (root / "oc_core" / "long.cpp").write_text("//\n" * (check_lengths.MAX_LINES + 1))
        (root / "oc_core" / "notes.md").write_text("-\n" * 1000)
        assert check_lengths.long_files(root) == [(601, pathlib.Path("oc_core/long.cpp"))]
        assert check_lengths.main(root) == 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
