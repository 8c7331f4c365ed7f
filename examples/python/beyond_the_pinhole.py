"""One scene by a pinhole and by three cameras that are not: what each of them samples."""

from _picture import pyplot, save, show

import ocelli

statues = ocelli.scene.load("builtin:statues")
figure, axes = pyplot.subplots(2, 2, figsize=(10, 7))
for place, name in zip(axes.flat, ["di", "ddoc", "eoc-h", "spoc"]):
    image = ocelli.render(statues, name, size=(480, 320))
    show(place, image.color, f"{name}: {image.sample_count} samples")
save(figure, "beyond_the_pinhole")
