"""Draws stack.png: the Mises stress of the main case, one quarter of the bearing cut away.

    cargo run --release -- run cases/section-2.6.2/initial-centre.toml
    python3 docs/images/stack.py results/initial-centre/initial-centre.pvd docs/images/stack.png
"""

import sys

import matplotlib
import numpy
import pyvista
from matplotlib.colors import ListedColormap

# Turbo without its near-black end.
COLOURS = ListedColormap(matplotlib.colormaps["turbo"](numpy.linspace(0.08, 0.97, 20)))

reader = pyvista.get_reader(sys.argv[1])
reader.set_active_time_value(reader.time_values[-1])
quarter = reader.read()[0]

# The model is the quarter x >= 0, y >= 0; the cut shows its two symmetry planes.
left = quarter.reflect((1, 0, 0), point=(0, 0, 0))
back = quarter.reflect((0, 1, 0), point=(0, 0, 0))
opposite = left.reflect((0, 1, 0), point=(0, 0, 0))

plotter = pyvista.Plotter(off_screen=True, window_size=(1100, 800))
plotter.set_background("white")
for part in (left, back, opposite):
    surface = part.extract_surface(algorithm="dataset_surface")
    edges = surface.extract_feature_edges(feature_angle=30)
    bar = {
        "title": "Mises stress, ksi",
        "color": "black",
        "vertical": True,
        "position_x": 0.87,
        "position_y": 0.2,
        "height": 0.6,
        "title_font_size": 20,
        "label_font_size": 18,
        "fmt": "%.0f",
    }
    plotter.add_mesh(
        surface,
        scalars="mises_nodal",
        clim=(0, 100),
        n_colors=20,
        cmap=COLOURS,
        ambient=0.45,
        diffuse=0.6,
        scalar_bar_args=bar,
        show_scalar_bar=part is opposite,
        smooth_shading=False,
    )
    plotter.add_mesh(edges, color="black", line_width=1.2)
plotter.camera_position = [(19, 15.5, 9), (0.3, 0.75, 0.25), (0, 0, 1)]
plotter.camera.parallel_projection = True
plotter.camera.parallel_scale = 6.5
plotter.screenshot(sys.argv[2])
