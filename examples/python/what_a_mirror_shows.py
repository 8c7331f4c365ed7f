"""Reflections by what stands for the scene behind them: pictures, where they are wrong, and how much."""

import numpy
from _picture import pyplot, save, show

import ocelli

ways = ["di", "ddoc", "cell"]
found = ocelli.effects.compare("builtin:mirror", "reflection", by=ways, size=(960, 640))
mirror = numpy.s_[100:520, 310:690]  # the part of the picture that shows it
figure, axes = pyplot.subplots(2, len(ways) + 1, figsize=(4 * (len(ways) + 1), 8.6))
for column, way in enumerate(found.figures):
    lost = found.figures[way]["lost"]
    show(axes[0, column], found.pictures[way][mirror], way if lost is None else f"{way}: {100 * lost:.1f} % of hits are lost")
    axes[1, column].axis("off")
    if "errors" in found.maps[way]:
        axes[1, column].imshow(found.maps[way]["errors"][mirror])
        axes[1, column].set_title("where it is wrong")
save(figure, "what_a_mirror_shows")
