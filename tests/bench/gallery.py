#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/gallery.md: gallery.py PYRASIM [NAME...], from the project's folder."""
import json
import pathlib
import subprocess
import sys
import tempfile

SIZE = "320x240"
SCENES = {
    "keel": "The article's subject: an aircraft's fin and rudder, and a wire thinner than a pixel.",
    "runway": "The same keel on its fuselage, with its shadow, a marking and a runway: textures and shadows.",
    "horizon": "A checkered plane to the horizon. Farther squares are averaged over what a pyramid covers of them: no moiré.",
    "columns": "Two rows of columns: boxes, cones and tori, their shadows, and the shadows' borders.",
    "shadows": "Solids and tubes under an evening sun and a lamp that fades.",
    "quadrics": "Cylinders, cones, ellipsoids, a cooling tower, a dish: closed, open and clipped.",
    "tori": "Rings of all thicknesses.",
    "knot": "A torus knot: a chain of 96 instances of one torus.",
    "crystals": "30 instances of one mesh of 24 triangles, turned, stretched, mirrored.",
    "buoys": "A mesh with materials, a picture and smooth normals, on striped water.",
    "spheres": "50 overlapping spheres of very different sizes.",
    "fins": "Long slivers at shallow slopes, some thinner than a pixel.",
    "blocks": "Boxes, discs and balls.",
    "bunny": "A mesh of 69,666 triangles, one object: levels do next to nothing inside its outline.",
}
DATABASES = {  # of tools/generate, at their published sizes
    "balls": (4, "A sphereflake: 7,381 spheres and a floor, under three lights."),
    "gears": (4, "Meshed gears: polygons of 144 corners and 4."),
    "mount": (6, "A fractal mountain of 8,192 triangles, and four spheres."),
    "rings": (7, "Interlaced pentagons of cylinders and spheres, piled up to a pyramid."),
    "tetra": (6, "A Sierpinski tetrahedron of 4,096 triangles."),
    "tree": (11, "A tree of cones and spheres."),
}
MAPS = ("cases", "rays", "latency")
HEAD = """# Gallery

Each scene at {size} pixels and MAX_LEVEL 3 on the default machine, 200 MHz: the picture; its case map; how many rays each
pixel asked for; and how many cycles each pixel took from its first ray on. All of it is made by

    tools/gallery

which runs, for each NAME,

    pyrasim simulate scenes/NAME.json --size {size} -o NAME.png --map cases=NAME_cases.png --map rays=NAME_rays.png --map latency=NAME_latency.png --stats -

In a case map night blue is a pixel that sees nothing, steel blue one that sees one object; nodes of a divided pixel are the
more orange the deeper they lie, and an edge that is left at the deepest level is light yellow. The other maps run from
dark (the least of the frame) over red to light yellow (the most), by logarithms. The last six are databases that
`tools/generate NAME SIZE > NAME.nff` writes, 240x240 pixels.
"""


def scene_of(name, folder):
    """Its file, made in `folder` where it is a database's; and its size."""
    if name in SCENES:
        return f"scenes/{name}.json", SIZE
    file = f"{folder}/{name}.nff"
    with open(file, "w") as output:
        subprocess.run(["tools/generate", name, str(DATABASES[name][0])], check=True, stdout=output)
    return file, "240x240"


def simulate(program, name, scene, size, folder):
    """The statistics of the frame, whose pictures go into `folder`."""
    maps = [word for kind in MAPS for word in ("--map", f"{kind}={folder}/{name}_{kind}.png")]
    run = subprocess.run([program, "simulate", scene, "--size", size, "-o", f"{folder}/{name}.png", *maps,
                          "--stats", "-"], check=True, capture_output=True, text=True)
    return json.loads(run.stdout)


def section(name, caption, document, folder):
    pixels = document["columns"] * document["rows"]
    machine, latency, rays = document["machine"], document["pixel_latency"]["all"], document["rays"]
    shadow = f" and {rays['shadow']['total'] / pixels:.2f} to lights" if rays["shadow"]["by_light"] else ""
    bottleneck = document["bottleneck"]["lower_bound"]["unit"]
    images = " ".join(f"![{name}, {kind}]({folder}/{name}{end}.png)" for kind, end in
                      [("picture", ""), *((kind, f"_{kind}") for kind in MAPS)])
    return (f"\n## {name}\n\n{caption}\n\n{images}\n\n"
            f"{rays['total'] / pixels:.2f} rays a pixel{shadow}; {machine['cycles']:,} cycles, "
            f"{machine['frames_per_second']:.1f} frames per second; a pixel takes {latency['p50']} cycles at the median and "
            f"{latency['max']:,} at most; the most work has {bottleneck}.\n")


def main():
    program, *names = sys.argv[1:]
    captions = SCENES | {name: caption for name, (_, caption) in DATABASES.items()}
    unknown = [name for name in names if name not in captions]
    if unknown:
        sys.exit(f"gallery: there is no {unknown[0]!r}; of {', '.join(captions)} any are allowed")
    folder = pathlib.Path("docs/images/gallery")
    folder.mkdir(parents=True, exist_ok=True)
    page = pathlib.Path("docs/gallery.md")
    old = page.read_text().split("\n## ") if names and page.exists() else []
    kept = {text.split("\n", 1)[0]: "\n## " + text for text in old[1:]}
    sections = []
    for name, caption in captions.items():
        if names and name not in names and name in kept:
            sections.append(kept[name])
            continue
        print(name, file=sys.stderr)
        with tempfile.TemporaryDirectory() as made:
            document = simulate(program, name, *scene_of(name, made), folder)
        sections.append(section(name, caption, document, "images/gallery"))
    page.write_text(HEAD.format(size=SIZE) + "".join(text.rstrip("\n") + "\n" for text in sections))


main()
