#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the program writes is as the JSON Schemas of cmodel/package/schemas say."""
import copy
import json
import sys
import unittest

sys.dont_write_bytecode = True
from program import HAS_RTL, PUBLIC, SCENES, TESTS, Program  # noqa: E402

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCHEMAS = TESTS.parent / "cmodel/package/schemas"
TEAPOT, CUBE = SCENES / "teapot.obj", SCENES / "cube.gltf"
SMALL = ("--size", "64x48")


@unittest.skipUnless(jsonschema, "jsonschema is not installed (package python3-jsonschema)")
class Schemas(Program):
    @classmethod
    def setUpClass(cls):
        cls.schemas = {p.name: json.loads(p.read_text()) for p in SCHEMAS.glob("*.schema.json")}

    def validator(self, name):
        schema = self.schemas[f"{name}.schema.json"]
        jsonschema.Draft7Validator.check_schema(schema)
        store = {s["$id"]: s for s in self.schemas.values()}
        return jsonschema.Draft7Validator(
            schema, resolver=jsonschema.RefResolver(schema["$id"], schema, store))

    def expect(self, name, value):
        """Valid; and not with a field less, nor with another type, nor, where that is promised,
        with a field more."""
        validator = self.validator(name)
        validator.validate(value)
        for key in self.schemas[f"{name}.schema.json"].get("required", []):
            less = copy.copy(value)
            del less[key]
            self.assertFalse(validator.is_valid(less), key)
            self.assertFalse(validator.is_valid(dict(value, **{key: [{}]})), key)
        if self.schemas[f"{name}.schema.json"].get("additionalProperties") is False:
            self.assertFalse(validator.is_valid(dict(value, another=1)))

    def json(self, name):
        return json.loads((self.out / name).read_text())

    def test_statistics(self):
        for level in ("coverage", "bit", "cycle"):
            shade = ["--shade", "coverage"] if level == "coverage" else []
            self.succeed("render", TEAPOT, *SMALL, "--level", level, *shade, "--out", "p.png",
                         "--stats", "s.json")
            self.expect("stats", self.json("s.json"))
        self.succeed("coverage", PUBLIC, "--out", "c.tcov", "--stats", "s.json")
        self.expect("stats", self.json("s.json"))

    def test_bench(self):
        self.succeed("bench", "--scale", "0.001", "--workload", "small", "--engine", "bit",
                     "coverage", "--repetitions", 1, "--out", "b.json")
        self.expect("bench", self.json("b.json"))

    def test_explain(self):
        for pixel in ((32, 24), (1, 1)):
            done = self.succeed("explain", CUBE, *pixel, *SMALL, "--json")
            self.expect("explain", json.loads(done.stdout))

    def test_explain_method(self):
        done = self.succeed("explain", CUBE, 32, 24, *SMALL, "--method", "edge_float_strict",
                            "--json")
        self.expect("explain_method", json.loads(done.stdout))

    @unittest.skipUnless(HAS_RTL, "this build has no RTL")
    def test_cosim(self):
        self.succeed("cosim", CUBE, *SMALL, "--stall", "0.2", "--stats", "s.json")
        self.expect("cosim", self.json("s.json"))

    def test_fit(self):
        self.succeed("fit", CUBE, "--size", "32x24", "--max-error", 1000, "--report", "r")
        self.expect("fit", self.json("r/report.json"))

    def test_config(self):
        for preset in ("tiny", "full", "d3d", "msaa4"):
            done = self.succeed("config", "--config", preset)
            self.expect("config", json.loads(done.stdout))

    def test_sweep(self):
        (self.out / "broken.obj").write_text("v 0 0 zero\n")
        values = {"scenes": [str(CUBE), "broken.obj"], "size": ["32x24"], "views": 2,
                  "config": [{"base": "full", "samples": [1, 4]},
                             {"subpixel_bits": {"from": 2, "to": 4, "step": 2}, "attributes": 0}],
                  "measure": ["coverage_error", "attribute_error", "clocks", "latency", "area"]}
        self.expect("sweep_specification", values)
        (self.out / "spec.json").write_text(json.dumps(values))
        self.assertEqual(self.run_program("sweep", "spec.json", "--out", "d").returncode, 1)
        lines = (self.out / "d/shard-00000-of-00001.jsonl").read_text().splitlines()
        self.assertEqual(len(lines), 17)
        for line in lines[:-1]:
            self.expect("sweep_record", json.loads(line))
        self.expect("shard_manifest", json.loads(lines[-1]))

    def test_specifications_that_the_program_refuses_are_invalid(self):
        sweep, soak = self.validator("sweep_specification"), self.validator("soak_specification")
        good = {"scenes": [str(CUBE)]}
        for change in ({"scene": []}, {"scenes": []}, {"size": ["3"]}, {"views": 0},
                       {"measure": ["speed"]}, {"config": {"sub": 1}}, {"config": []},
                       {"config": {"samples": []}}, {"config": {"samples": "4"}}, {"stall": 1}):
            values = dict(good, **change)
            self.assertFalse(sweep.is_valid(values), values)
            (self.out / "spec.json").write_text(json.dumps(values))
            self.refuse("HS100", "sweep", "spec.json", "--out", "d")
        for values in ({"seeds": 1}, {"checks": ["all"]}, {"shapes": []}, {"triangles": 0}):
            self.assertFalse(soak.is_valid(values), values)
        soak.validate({"seed": 3, "checks": ["oracle"], "shapes": ["tiny"]})


if __name__ == "__main__":
    unittest.main()
