#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The chart of a sweep: Pareto points against the definition, the choice under limits, the page."""
import html.parser
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "testbench/sweep"))
import sweep_chart  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"


def record(case, area, ppm, speed, scene="a<b>&.obj", samples=1):
    return {"case": case, "scene": scene, "size": "32x24", "view": 0,
            "config": {"subpixel_bits": case % 13, "grid_log2": 3, "samples": samples},
            "area": {"luts": area}, "coverage_error": {"ppm": ppm},
            "clocks": {"pixels_per_clock": speed}}


class SweepChart(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)

    def write(self, records):
        path = self.out / "sweep.jsonl"
        path.write_text("".join(json.dumps(r) + "\n" for r in records))
        return path

    def test_pareto_points_are_those_of_the_definition(self):
        draw = random.Random(5)
        records = [record(i, draw.randint(1, 9), draw.randint(0, 9), draw.randint(1, 9),
                          samples=draw.choice((1, 4))) for i in range(300)]
        groups = sweep_chart.read(self.write(records))
        self.assertEqual(len(groups), 2)
        for points in groups.values():
            for p in points:
                better = [q for q in points
                          if q.area <= p.area and q.ppm <= p.ppm and q.speed >= p.speed
                          and (q.area, q.ppm, q.speed) != (p.area, p.ppm, p.speed)]
                self.assertEqual(p.is_pareto, not better, (p.area, p.ppm, p.speed))

    def test_the_choice_is_the_smallest_that_keeps_both_limits(self):
        points = next(iter(sweep_chart.read(self.write([
            record(0, 10, 500, 4), record(1, 20, 50, 4), record(2, 30, 50, 8)])).values()))
        chosen = [sweep_chart.choice(points, *limits) for limits in
                  ((1000, 1), (100, 1), (100, 5), (100, 9), (10, 1))]
        self.assertEqual([p and p.area for p in chosen], [10, 20, 30, None, None])

    def test_the_page_holds_every_record_and_nothing_it_should_not(self):
        path = self.write([record(0, 10, 0, 4), record(1, 20, 50, 4, scene="</script><b>"),
                           {"case": 2, "error": {"code": "HS011", "text": "x"}}])
        done = subprocess.run([sys.executable, ROOT / "testbench/sweep/sweep_chart.py", path,
                               self.out / "d"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.out / "d/index.html").read_text()
        data = re.search(r'id="records">(.*?)</script>', page)[1]
        self.assertEqual([r["case"] for r in json.loads(data)], [0, 1])
        tags = []
        parser = html.parser.HTMLParser()
        parser.handle_starttag = lambda tag, _: tags.append(tag)
        parser.feed(page)
        self.assertNotIn("b", tags, "a scene's name became an element")
        circles = xml.etree.ElementTree.parse(self.out / "d/sweep.svg").iter(f"{SVG}circle")
        self.assertEqual([c.get("data-point") for c in circles], ["0", "1"])

    def test_a_sweep_without_the_three_is_refused(self):
        path = self.write([{"case": 0, "error": {"code": "HS011", "text": "x"}}])
        done = subprocess.run([sys.executable, ROOT / "testbench/sweep/sweep_chart.py", path,
                               self.out / "d"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no case has coverage_error, clocks and area", done.stderr)
        self.assertFalse((self.out / "d").exists())


if __name__ == "__main__":
    unittest.main()
