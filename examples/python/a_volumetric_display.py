"""A scene on a swept-screen display: one slice, and what an eye in front of it sees."""

from _picture import pyplot, save, show

import ocelli

volume = ocelli.slice("builtin:teapot", "perspecta")
seen = ocelli.observe(volume, size=(480, 480))
figure, axes = pyplot.subplots(1, 2, figsize=(10, 5))
axes[0].imshow(volume.levels(66))
axes[0].set_title(f"slice 67 of {volume.slices}")
axes[0].axis("off")
show(axes[1], seen.clip(0, 1), "from 50 inches")
save(figure, "a_volumetric_display")
