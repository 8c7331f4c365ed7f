"""A sea of images: panoramas of a place in one file, any of which is had at once, and views from between them."""

import pathlib
import tempfile

from _picture import pyplot, save

import ocelli

places = [(x, 1.6, z) for z in (0, 0.25, 0.5) for x in (-0.5, -0.25, 0, 0.25, 0.5)]
with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "house.sea"
    sea = ocelli.sea.build("builtin:house", path, positions=places, size=(512, 256), proxy_triangles=5000)
    pixels = len(sea) * sea[0].size
    figure, (one, between) = pyplot.subplots(2, 1, figsize=(8, 9))
    one.imshow(sea[7])
    one.set_title(f"one of {len(sea)} images, stored in {sea.bytes / 1000:.0f} kB: {pixels / sea.bytes:.0f} : 1")
    between.imshow(sea.view((0.1, 1.6, 0.1)))
    between.set_title("from between them, made of the nearest three")
    for axes in (one, between):
        axes.axis("off")
    save(figure, "any_image_of_a_sea")
