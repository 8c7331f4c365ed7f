"""A maze in one image: the comprehensive graph camera, beside what a pinhole sees from the same place."""

from _picture import pyplot, save, show

import ocelli

maze = ocelli.scene.load("builtin:maze")
whole = ocelli.render(maze, "comprehensive", size=(900, 560))
above = ocelli.render(maze, view=ocelli.View(eye=(0, 2.5, 0.01), fov_vertical_degrees=50), size=(560, 560))
figure, axes = pyplot.subplots(1, 2, figsize=(13, 5), width_ratios=[560, 900])
show(axes[0], above.color, "from above")
show(axes[1], whole.color, "comprehensive: every corridor once")
save(figure, "a_whole_maze")
