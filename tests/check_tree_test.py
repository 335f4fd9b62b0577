#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_tree_test.py ROOT: check_tree.py finds each of these faults, put into the tree one at a
time and in memory alone. Nothing else is found."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_tree  # noqa: E402

# File, what stands there, what it becomes, what is said. Without the second the whole file changes;
# without the third it is gone.
FAULTS = [
    ("tests/tile_traversal_cosim_test.cpp", None, None, "traversal_cosim_test.cpp: missing"),
    ("rtl/checkers/hs_tile_traversal_checker.sv", None, None, "traversal_checker.sv: missing"),
    ("rtl/hs_depth.sv", None, "module hs_depth; endmodule", "listed as lacking"),
    ("cmodel/scissor.hpp", "Twin: none yet in rtl/.", "", "names no twin"),
    ("cmodel/samples.hpp", "(SAMPLE_X,", "(sample_x,", "no sample_x there"),
    ("rtl/hs_coverage.sv", "halfspace::coverage()", "halfspace::cover()", "no cover there"),
    ("cmodel/half_plane_grid.hpp", "hs_box_range.sv", "hs_box_mask.sv", "no such file"),
    ("cmodel/coverage.hpp", '"packets.hpp"', '"tile_traversal.hpp"', "a stage knows no other"),
    ("cmodel/geometry.cpp", '"fixed.hpp"', '"interpolation.hpp"', "a stage knows no other"),
    ("cmodel/coverage.cpp", '"half_plane_grid.hpp"', '"fixed.hpp"', "no longer includes half_plane"),
    ("cmodel/fixed.cpp", "<cstdio>", "<iostream>", "no I/O"),
    ("cmodel/io/png_file.cpp", '"error.hpp"', '"../scene/scene.hpp"', "no arrow from cmodel/io"),
    ("cmodel/meshes/finish_mesh.cpp", '"../io/error.hpp"', '"../scene/scene.hpp"',
     "no arrow from cmodel/meshes"),
    ("testbench/oracle/oracle.cpp", '"oracle.hpp"', '"fixed.hpp"', "no arrow from testbench/oracle"),
    ("cmodel/scene/scene.hpp", "class Scene {", "class Progress {", "both define halfspace::Progr"),
    ("testbench/lab/CMakeLists.txt", "  suites.cpp", "  ../cli/pictures.cpp", "of another folder"),
    ("cmodel/hit_count.cpp", '"hit_count.hpp"', '"io/error.hpp"', "no arrow from cmodel to"),
    ("cmodel/camera.hpp", "<glm/vec3.hpp>", "<hwy/highway.h>", "GLM alone"),
    ("cmodel/snap.hpp", "#include", "#define HS_SNAP(x) x\n#include", "macro HS_SNAP"),
    ("docs/02_use/errors.md", "## HS042", "## HS142", "is in only one"),
    ("README.md", "(docs/02_use/fit.md)", "(docs/02_use/fits.md)", "broken link docs/02_use/fits"),
    ("README.md", "bench.md#measured", "bench.md#times", "bench.md#times: no such heading"),
    ("CONTRIBUTING.md", "Faults and wishes", "Faults, questions and wishes", "columns of prose"),
    ("docs/04_develop/add_a_stage.md", "cmodel/rasterizer.hpp`", "cmodel/rasteriser.hpp`",
     "rasteriser.hpp is not there"),
    ("CMakeLists.txt", "VERSION 0.1.0", "VERSION 0.2.0", "0.2.0"),
    ("docs/charts/ladder.json", '"cpu_seconds": 0.0842', '"cpu_seconds": 0.0942',
     "`rtl` takes 36 times as long"),
    ("docs/charts/subpixel_area.json", '"luts": 10878', '"luts": 10879', "8,781 to 10,879"),
    ("docs/charts/efficiency.json", "24.72169", "23.72169", "it covers 2.4 times"),
    ("docs/charts/interpolation.json", "0.5490", "0.5763", "a reciprocal of 14 bits"),
    ("docs/charts/accumulator.json", "52036.56", "32036.56", "3 to 5 % of samples"),
    ("docs/charts/peers.json", '"ns_per_triangle": 5398.858', '"ns_per_triangle": 6398.858',
     "level coverage is 17 times"),
    ("docs/charts/peers.json", '"ns_per_triangle": 8599.85', '"ns_per_triangle": 9999.85',
     "the frame engine is 2.3"),
    ("docs/charts/methods.json", '52.143488', '952.143488', "The engine is not faster"),
    ("docs/charts/area.json", '"luts": 25309', '"luts": 25310', "25,310, 8,781"),
    ("docs/02_use/vectors.md", "391 of 391", "392 of 392", "all: 392, 756"),
    ("docs/02_use/bench.md", "(8.07)", "(8.27)", "4.6 to 8.3"),
    ("docs/03_design/timing.md", "1.260 per tile", "1.270 per tile", "1.27 clocks a tile"),
    ("tests/data/public.tcov", "TCOV 1 320", "TCOV 1 321", "321 cases"),
    ("docs/05_methods/README.md", "`clip_near` ", "", "118 variants"),
    ("tests/dpi_test.py", "FAULTS = [\n", "FAULTS = [\n    (),\n", "9 of 9"),
    ("CITATION.cff", "date-released: 20", "date-released: 19", "no release"),
    (".github/CODEOWNERS", "@example.invalid", "@other.invalid", "the maintainers are"),
]


def main():
    root = pathlib.Path(sys.argv[1])
    failed = 0
    for path, old, new, expected in FAULTS:
        changed = new
        if old is not None:
            changed = (root / path).read_text().replace(old, new)
        found = check_tree.problems(check_tree.Tree(root, {path: changed}))
        if not found or not all(expected in problem for problem in found):
            print(f"{path}: '{old}' as '{new}': not found as '{expected}', but as {found}")
            failed += 1
    print(f"{len(FAULTS) - failed} of {len(FAULTS)} faults found")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
