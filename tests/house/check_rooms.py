"""Checks the rooms of docs/architecture.md: who includes whom, which third-party headers stand where, and what is linked.

Usage: check_rooms.py ROOT. Prints one line a violation and exits with 1 where there is one.
"""

import pathlib
import re
import sys

TABLE = "docs/architecture.md"
EVERYTHING = "everything"

# Prefix of a third-party include -> the CMake target that a room which includes it must link.
THIRD_PARTIES = {
    "glm/": "glm::glm",
    "png.h": "PNG::PNG",
    "zlib.h": "ZLIB::ZLIB",
    "tbb/": "TBB::tbb",
    "oneapi/tbb/": "TBB::tbb",
    "nlohmann/": "nlohmann_json::nlohmann_json",
    "assimp/": "assimp::assimp",
    "hwy/": "hwy::hwy",
    "isa-l/": "PkgConfig::isal",
    "mpi.h": "MPI::MPI_CXX",
    "jpeglib.h": "PkgConfig::jpeg",
    "webp/": "PkgConfig::webp",
    "jxl/": "PkgConfig::jxl",
    "microhttpd.h": "PkgConfig::microhttpd",
    "libwebsockets.h": "PkgConfig::libwebsockets",
    "libusb.h": "PkgConfig::libusb",
    "umockdev.h": "PkgConfig::umockdev",
    "gio/": "PkgConfig::umockdev",
    "glib": "PkgConfig::umockdev",
    "meshoptimizer.h": "meshoptimizer::meshoptimizer",
    "embree3/": "embree",
    "openvdb/": "OpenVDB::openvdb",
    "opencv2/": "OpenCV::video",
    "opencv2/aruco/": "OpenCV::calibration",
    "opencv2/calib3d.hpp": "OpenCV::calibration",
    "opencv2/stitching.hpp": "OpenCV::stitching",
    "apriltag/": "PkgConfig::apriltag",
    "libavcodec/": "PkgConfig::ffmpeg",
    "libavdevice/": "PkgConfig::ffmpeg",
    "libavformat/": "PkgConfig::ffmpeg",
    "libavutil/": "PkgConfig::ffmpeg",
    "libswscale/": "PkgConfig::ffmpeg",
    "pybind11/": "pybind11::module",
    "Recast.h": "Recast::recast",
    "Imf": "PkgConfig::OpenEXR",
    "Imath": "PkgConfig::OpenEXR",
    "Iex": "PkgConfig::OpenEXR",
    "OpenEXR/": "PkgConfig::OpenEXR",
    "cairo": "PkgConfig::cairo",
    "stb/": "PkgConfig::stb",
    "gdcm": "GDCM::gdcm",
    "teem/": "Teem::teem",
    "nifti2_io.h": "NIFTI::nifti2",
    "pugixml.hpp": "PkgConfig::pugixml",
    "zstd": "zstd::libzstd_shared",
    "CLI/": "CLI11::CLI11",
    "fmt/": "fmt::fmt",
    "gtest/": "GTest::gtest",
    "gmock/": "GTest::gmock",
    "benchmark/": "benchmark::benchmark",
    "GL/": "PkgConfig::OSMesa",
    "GLFW/": "glfw",
    "imgui": "PkgConfig::imgui",
    "fontconfig/": "PkgConfig::fontconfig",
    "fribidi": "PkgConfig::fribidi",
    "openssl/": "OpenSSL::Crypto",
    "SQLiteCpp/": "SQLiteCpp",
    "sqlite3.h": "SQLiteCpp",
    "Eigen/": "Eigen3::Eigen",
    "nlopt": "PkgConfig::nlopt",
    "boost/": "Boost::headers",
    # Functions that are looked up at run time: nothing is linked.
    "EGL/": None,
    "GL/osmesa.h": None,
    "glad/": None,
    # Peers of benchmarks, which most machines lack.
    "vtk": None,
}
# Made by ocelli_embed_shaders() in the build tree, for .cpp files.
GENERATED_SHADERS = "shaders.h"
# Projects of their own: a file there may include one beside it.
PROJECTS = "examples/"
# Found without a target: the system's own headers.
SYSTEM_PREFIXES = (
    "sys/", "fuzzer/", "unistd.h", "dirent.h", "fcntl.h", "stdlib.h", "immintrin.h", "malloc.h", "dlfcn.h", "poll.h", "pty.h", "termios.h", "netdb.h", "spawn.h", "linux/", "netinet/",
    "arpa/",
)

ALLOWED_IN_PUBLIC_HEADERS = {"glm/"}
PUBLIC_HEADER_EXCEPTIONS = {
    "analysis/inference/cluster_jackknife.h": {"Eigen/"},
    "analysis/inference/standardized_covariates.h": {"Eigen/"},
    "analysis/models/binomial_mixed_model.h": {"Eigen/"},
    "analysis/models/censored_mixed_model.h": {"Eigen/"},
    "analysis/models/design.h": {"Eigen/"},
    "analysis/models/laplace_fit.h": {"Eigen/"},
    "analysis/models/laplace_integral.h": {"Eigen/"},
    "analysis/models/linear_mixed_model.h": {"Eigen/"},
    "analysis/models/marginal_probability.h": {"Eigen/"},
    "analysis/models/minimum.h": {"Eigen/"},
    "analysis/models/mixed_model.h": {"Eigen/"},
    "analysis/models/quadrature.h": {"Eigen/"},
    "analysis/models/random_structure.h": {"Eigen/"},
    "analysis/models/response_family.h": {"Eigen/"},
    "analysis/models/separation.h": {"Eigen/"},
    "oc_core/base/json_document.h": {"nlohmann/"},
    "oc_core/base/json_fields.h": {"nlohmann/"},
    "oc_core/constructor/camera_fields.h": {"nlohmann/"},
    "oc_core/feeds/feed_fields.h": {"nlohmann/"},
    "oc_core/scene/import/gltf_file.h": {"nlohmann/"},
    "oc_core/gl/gl_api.h": {"glad/"},
    "oc_core/volume_render/march_field-inl.h": {"hwy/"},
    "oc_core/volume_render/march_ray-inl.h": {"hwy/"},
    "oc_core/volume_render/march_steps-inl.h": {"hwy/"},
    "oc_core/feeds_calibration/opencv_board.h": {"opencv2/aruco/"},
    "study/export/export_tables.h": {"SQLiteCpp/"},
    "study/store/database_state.h": {"SQLiteCpp/"},
    "study/store/sqlite_connection.h": {"SQLiteCpp/"},
    "study/store/trial_writer.h": {"SQLiteCpp/"},
    "study/trial/stored_row.h": {"SQLiteCpp/"},
    "study/trial/trials_file.h": {"SQLiteCpp/"},
    "display_driver/emulator/usb_emulator_state.h": {"umockdev.h"},
    "display_driver/usb/usb_context.h": {"libusb.h"},
    "display_driver/usb/usb_handles.h": {"libusb.h"},
    "display_driver/usb/usb_link.h": {"libusb.h"},
}
# For .cpp files only, as they say themselves: a header that includes one would spread its cost. Matrices are results.
SOURCE_ONLY_HEADERS = {header for header, libraries in PUBLIC_HEADER_EXCEPTIONS.items() if libraries != {"Eigen/"}}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')


def read_rooms(root):
    """The table as {folder: set of folders it may include, or EVERYTHING}, closed under "through"."""
    direct = {}
    for line in (root / TABLE).read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) == 3 and re.fullmatch(r"`[\w/]+/`", cells[0]):
            direct[cells[0].strip("`")] = EVERYTHING if cells[2] == EVERYTHING else set(re.findall(r"`([\w/]+/)`", cells[2]))

    def reach(folder, seen):
        for other in direct if direct[folder] == EVERYTHING else direct[folder]:
            # `oc_core/` stands for each of its rooms.
            for room in [room for room in direct if room.startswith(other)]:
                if room not in seen:
                    seen.add(room)
                    reach(room, seen)
        return seen

    return {folder: reach(folder, {folder}) for folder in direct}


def room_of(path, rooms):
    matches = [room for room in rooms if path.startswith(room)]
    return max(matches, key=len) if matches else None


def third_party_prefix(name):
    matches = [prefix for prefix in THIRD_PARTIES if name.startswith(prefix)]
    return max(matches, key=len) if matches else None


def includes_of(file):
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) == '"', match.group(2)


def source_files(root, room, rooms):
    for file in sorted((root / room).rglob("*")):
        path = file.relative_to(root).as_posix()
        if file.suffix in (".h", ".cpp") and room_of(path, rooms) == room:
            yield path, file


def links_of(root, room):
    """Targets that the ocelli_room() of this room links, or None where it is no library of its own."""
    lists = root / room / "CMakeLists.txt"
    text = re.sub(r"#.*", "", lists.read_text(encoding="utf-8")) if lists.exists() else ""
    match = re.search(r"ocelli_room\(\s*(\w+)(.*?)\n?\)", text, re.DOTALL)
    return None if match is None else (match.group(1), set(re.findall(r"[\w]+(?:::\w+)+|\bembree\b|\bglfw\b|\bSQLiteCpp\b", match.group(2))))


def check_include(path, number, own, name, room, rooms, root):
    where = f"{path}:{number}: "
    public_header = path.endswith(".h") and room.startswith(("oc_core/", "display_", "study/", "analysis/"))
    if own and room == PROJECTS and ((root / path).parent / name).exists():
        return None
    if own:
        other = room_of(name, rooms)
        generated = other is not None and name == f"{other}{GENERATED_SHADERS}" and path.endswith(".cpp")
        if generated and (other == room or other in rooms[room]):
            return None
        if other is None or not (root / name).exists():
            return f'{where}"{name}" is no file of a room; give the path from the top of the project'
        if other not in rooms[room]:
            return f'{where}{room} may not include {other} ("{name}")'
        if name in SOURCE_ONLY_HEADERS and path.endswith(".h") and path not in SOURCE_ONLY_HEADERS:
            return f'{where}"{name}" is for .cpp files only'
        return None
    prefix = third_party_prefix(name)
    if prefix is None:
        standard = re.fullmatch(r"[a-z_0-9]+", name) is not None
        if not standard and not name.startswith(SYSTEM_PREFIXES):
            return f"{where}<{name}> is not known; add its library to THIRD_PARTIES in tests/house/check_rooms.py"
        return None
    allowed = ALLOWED_IN_PUBLIC_HEADERS | PUBLIC_HEADER_EXCEPTIONS.get(path, set())
    if public_header and prefix not in allowed:
        return f"{where}<{name}> may not stand in a public header; include it in the .cpp file"
    return None


def check_links(root, rooms, used):
    """What a room links must be allowed by the table, and what it includes must be linked, directly or through a room."""
    links = {room: links_of(root, room) for room in rooms}
    rooms_by_target = {f"Ocelli::{links[room][0]}": room for room in rooms if links[room]}

    def closure(room, seen):
        for target in links[room][1] if links[room] else ():
            if target not in seen:
                seen.add(target)
                if target in rooms_by_target:
                    closure(rooms_by_target[target], seen)
        return seen

    for room in rooms:
        if links[room] is None:
            continue
        where = f"{room}CMakeLists.txt: "
        for target in sorted(links[room][1]):
            if target.startswith("Ocelli::") and target not in rooms_by_target:
                yield f"{where}{target} is no room"
            elif target in rooms_by_target and rooms_by_target[target] not in rooms[room]:
                yield f"{where}{room} may not link {target}"
        linked = closure(room, set())
        for needed in sorted(used[room]):
            target = needed
            if needed in rooms:
                target = f"Ocelli::{links[needed][0]}" if links[needed] else None
            if target not in linked and needed != room:
                yield f"{where}{room} includes headers of {needed} but does not link it"


def violations(root):
    root = pathlib.Path(root)
    rooms = read_rooms(root)
    if not rooms:
        yield f"{TABLE}: the table of rooms is missing"
    used = {room: set() for room in rooms}
    for room in rooms:
        for path, file in source_files(root, room, rooms):
            for number, own, name in includes_of(file):
                problem = check_include(path, number, own, name, room, rooms, root)
                if problem:
                    yield problem
                elif own:
                    used[room].add(room_of(name, rooms))
                elif third_party_prefix(name) and THIRD_PARTIES[third_party_prefix(name)]:
                    used[room].add(THIRD_PARTIES[third_party_prefix(name)])
    yield from check_links(root, rooms, used)
    for file in sorted(root.glob("*/")):
        if file.is_dir() and any(file.glob("**/*.cpp")) and not file.name.startswith(("build", ".")):
            if not any(room.startswith(file.name + "/") for room in rooms):
                yield f"{file.name}/ holds code but is no room of {TABLE}"


if __name__ == "__main__":
    found = list(violations(sys.argv[1]))
    print("\n".join(found) if found else "every include and link is allowed")
    sys.exit(1 if found else 0)
