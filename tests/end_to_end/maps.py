# SPDX-License-Identifier: Apache-2.0
"""Maps of what pixels took: their numbers against the statistics, and mistakes."""

import tool
from tool import SCENES, USAGE

FRAME = [SCENES / "keel.json", "--size", "64x48"]


class Maps(tool.EndToEnd):
    def numbers(self, name):
        """Rows from the top are those of the picture."""
        columns, rows, _ = tool.read_pfm(self.folder / name)
        values = tool.pfm_values(self.folder / name)
        self.assertEqual(values[0::3], values[1::3])
        self.assertEqual(values[0::3], values[2::3])
        self.assertEqual((columns, rows), (64, 48))
        return values[0::3]

    def test_numbers_are_those_of_the_statistics(self):
        document = self.stats("simulate", *FRAME, "--map", "rays=rays.pfm", "--map", "latency=latency.pfm")
        rays, latency = self.numbers("rays.pfm"), self.numbers("latency.pfm")
        self.assertEqual(sum(rays) + 64 + 48 + 1, document["rays"]["total"])
        accounts = document["pixel_latency"]
        self.assertEqual(max(latency), accounts["all"]["max"])
        self.assertAlmostEqual(sum(latency) / len(latency), accounts["all"]["mean"], 6)
        for slow in accounts["slowest"]:
            self.assertEqual(latency[slow["row"] * 64 + slow["column"]], slow["cycles"])

    def test_render_and_simulate_make_the_same(self):
        for kind in ("cases", "rays"):
            self.ok("render", *FRAME, "--map", f"{kind}=render.pfm", "--threads", "2")
            self.ok("simulate", *FRAME, "--map", f"{kind}=simulate.pfm", "--engine", "lockstep")
            self.assertEqual((self.folder / "render.pfm").read_bytes(), (self.folder / "simulate.pfm").read_bytes())

    def test_the_table_says_what_colours_mean(self):
        said = self.ok("render", *FRAME, "--map", "rays=rays.png")
        self.assertRegex(said, "map +rays.png: 1 ray a pixel, dark, to [0-9]+, light")

    def test_the_gallery_shows_every_scene(self):
        page = (tool.SOURCE / "docs" / "gallery.md").read_text()
        for scene in SCENES.glob("*.json"):
            for end in ("", "_cases", "_rays", "_latency"):
                picture = f"images/gallery/{scene.stem}{end}.png"
                self.assertIn(f"]({picture})", page)
                self.assertTrue((tool.SOURCE / "docs" / picture).exists(), picture)

    def test_mistakes(self):
        self.refused(USAGE, "render", *FRAME, "--map", "latency=x.png", says="of the kinds cases, rays")
        self.refused(USAGE, "simulate", *FRAME, "--map", "heat=x.png", says="of the kinds cases, rays, latency")
        self.refused(USAGE, "simulate", *FRAME, "--map", "rays", says="KIND=FILE is allowed")
        self.refused(USAGE, "simulate", *FRAME, "--map", "rays=x.jpg", says=".png")
        self.refused(USAGE, "simulate", *FRAME, "--map", "rays=x.png", "-o", "x.png", says="one file")
        self.refused(USAGE, "simulate", *FRAME, "--map", "rays=x.png", "--map", "cases=x.png", says="one file")
        self.refused(USAGE, "render", *FRAME, "--method", "grid:4", "--map", "rays=x.png", says="--method grid:4 has none")
        self.assertEqual(list(self.folder.iterdir()), [])


tool.main()
