# What stands below is the same for every run.

import math
import os

from paraview import servermanager
from paraview.simple import *
from paraview.vtk.util.numpy_support import vtk_to_numpy
import numpy

PICTURE = [1600, 1200]
GREY = [0.45, 0.45, 0.45]
# From blue to red, light enough to be shaded: share of the largest value, red, green, blue.
COLOURS = [
    [0.00, 0.33, 0.42, 0.80],
    [0.20, 0.25, 0.70, 0.93],
    [0.40, 0.33, 0.83, 0.55],
    [0.60, 0.85, 0.88, 0.33],
    [0.80, 0.98, 0.62, 0.22],
    [1.00, 0.78, 0.12, 0.15],
]


def folder():
    """The folder of this file. ParaView's window does not tell a script where it lies, so there its
    own command line is looked at, then where it was started, then where the run was written."""
    places = [globals()["__file__"]] if "__file__" in globals() else []
    try:
        with open("/proc/self/cmdline") as words:
            places += [w.split("=", 1)[-1] for w in words.read().split("\0") if w.endswith(".py")]
    except OSError:
        pass
    places = [os.path.dirname(os.path.abspath(place)) for place in places]
    places += [os.getcwd(), FOLDER]
    for place in places:
        if os.path.exists(os.path.join(place, NAME + ".pvd")):
            return place
    raise RuntimeError(NAME + ".pvd is in none of: " + ", ".join(places))


def axis_vector(axis, length=1.0):
    return [length if i == axis else 0.0 for i in range(3)]


def fetched(source):
    """The one grid of a part: positions, a function for the fields of its points, its cells, and
    the number that each of these belongs to."""
    data = servermanager.Fetch(source)
    if data.IsA("vtkCompositeDataSet"):
        leaf = data.NewIterator()
        leaf.InitTraversal()
        data = leaf.GetCurrentDataObject()
    positions = vtk_to_numpy(data.GetPoints().GetData())
    corners = data.GetCell(0).GetNumberOfPoints()
    cells = vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, corners)

    def field(name):
        return vtk_to_numpy(data.GetPointData().GetArray(name))

    of_cells = vtk_to_numpy(data.GetCellData().GetArray("interface" if corners == 4 else "body"))
    return positions, field, cells, of_cells


def part(collection, index, name):
    """One of the parts of the collection: 0 the bodies, 1 the contact surfaces."""
    block = ExtractBlock(registrationName=name, Input=collection)
    try:
        block.Selectors = ["/Root/*[%d]" % (index + 1)]
    except AttributeError:  # before ParaView 5.10
        block.BlockIndices = [2 * index + 1]
    return block


def whole(source):
    """The source with its images in the planes of symmetry."""
    for axis in MIRRORS:
        image = Transform(Input=source, registrationName="image in " + "xyz"[axis] + " = 0")
        image.Transform.Scale = [-1.0 if i == axis else 1.0 for i in range(3)]
        image.TransformAllInputVectors = 1
        source = GroupDatasets(Input=[source, image])
    return source


def strips(contacts):
    """Of each interface that presses: the box around its pressed points, lowest and highest corner."""
    positions, field, faces, interface = contacts
    pressed = field("contact_pressure") > 0.02 * field("contact_pressure").max()
    boxes = []
    for number in sorted(set(interface)):
        nodes = numpy.unique(faces[interface == number])
        touched = positions[nodes[pressed[nodes]]]
        if len(touched) > 0:
            boxes.append((touched.min(axis=0), touched.max(axis=0)))
    return boxes


def cut_place(box, boxes):
    """Where the two cuts go: through the strips that run along each of them, or the middle."""
    place = [0.5 * (low + high) for low, high in zip(*box)]
    for axis in ACROSS:
        thin = [b for b in boxes if min(ACROSS, key=lambda i: b[1][i] - b[0][i]) == axis]
        if axis in MIRRORS:
            place[axis] = 0.0
        elif thin:
            place[axis] = sum(0.5 * (low[axis] + high[axis]) for low, high in thin) / len(thin)
    return place


def quarter_away(source, place, size):
    """The source without the quarter that faces the viewer."""
    far = 10.0 * size
    position = [place[i] - far if i in ACROSS else -far for i in range(3)]
    length = [far if i in ACROSS else 2.0 * far for i in range(3)]
    cut = Clip(registrationName="a quarter cut away", Input=source, ClipType="Box")
    cut.ClipType.Position = position
    cut.ClipType.Rotation = [0.0, 0.0, 0.0]
    cut.ClipType.Length = length
    cut.Invert = 0
    return cut


def edges_of(source):
    surface = ExtractSurface(Input=source)
    return FeatureEdges(registrationName="edges", Input=surface, FeatureAngle=30.0, NonManifoldEdges=0)


def new_view(title):
    view = CreateView("RenderView")
    view.ViewSize = [PICTURE[0] // 2, PICTURE[1] // 2]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]
    text = Text(registrationName=title, Text=title)
    display = Show(text, view)
    display.Color = [0.0, 0.0, 0.0]
    display.FontSize = 13
    display.Justification = "Left"
    display.WindowLocation = "Upper Left Corner"
    return view


def draw(source, view, field, title, largest):
    """Shows a source coloured by a field of its points, from zero to its largest value."""
    if field not in source.PointData.keys():
        raise RuntimeError("there is no field " + field)
    display = Show(source, view)
    display.Representation = "Surface"
    display.EdgeColor = [0.25, 0.25, 0.25]
    ColorBy(display, ("POINTS", field))
    colours = GetColorTransferFunction(field)
    colours.ColorSpace = "RGB"
    colours.RGBPoints = [x for share, *colour in COLOURS for x in [share * largest, *colour]]
    colours.NumberOfTableValues = 20
    bar = GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.TitleFontSize, bar.LabelFontSize = 14, 13
    bar.AutomaticLabelFormat, bar.AddRangeLabels, bar.LabelFormat = 0, 0, "%.3g"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [0.83, 0.25], 0.5
    display.SetScalarBarVisibility(view, True)
    return display


def draw_plain(source, view, opacity, width=1.0):
    display = Show(source, view)
    ColorBy(display, ("POINTS", None))
    display.AmbientColor = display.DiffuseColor = GREY
    display.Opacity = opacity
    display.LineWidth = width
    return display


def look(view, focus, size, direction):
    """Looks at `focus` from `direction`; `size` fills the height of the picture."""
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = list(focus)
    view.CameraPosition = [f + 10.0 * size * d for f, d in zip(focus, direction)]
    view.CameraViewUp = axis_vector(UP, SIGN)
    view.CameraParallelScale = 0.5 * size
    view.CenterOfRotation = list(focus)


def rounded(value):
    """1, 2 or 5 times a power of ten, at most `value`."""
    power = 10.0 ** math.floor(math.log10(value))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= value * (1.0 + 1e-9))


def short(value):
    return "%.4g" % value


def main():
    here = folder()
    in_window = bool(GetRenderViews())
    run = PVDReader(registrationName=NAME, FileName=os.path.join(here, NAME + ".pvd"))
    run.UpdatePipelineInformation()
    done = [time for time in run.TimestepValues if time <= FULL_LOAD * (1.0 + 1e-12)]
    time = max(done)
    run.UpdatePipeline(time)
    moment = "full load" if time == FULL_LOAD else "before full load: step %s" % short(time)

    bodies = part(run, 0, "bodies")
    bodies.UpdatePipeline(time)
    positions, field, _, _ = fetched(bodies)
    mises, displacement = field("mises_nodal"), numpy.linalg.norm(field("displacement"), axis=1)
    low, high = positions.min(axis=0), positions.max(axis=0)
    for axis in MIRRORS:
        low[axis], high[axis] = min(low[axis], -high[axis]), max(high[axis], -low[axis])
    size = float(numpy.linalg.norm(high - low))
    middle = 0.5 * (low + high)
    boxes, pressure = [], 0.0
    if CONTACT:
        contacts = part(run, 1, "contact surfaces")
        contacts.UpdatePipeline(time)
        fields = fetched(contacts)
        boxes = strips(fields)
        pressure = float(fields[1]("contact_pressure").max())

    # A slice of a long body is looked at from its side; of all else a quarter is cut away.
    flat = [axis for axis in ACROSS if high[axis] - low[axis] < 0.05 * size]
    direction = [-0.62, -0.62, -0.62]
    direction[ACROSS[0]], direction[ACROSS[1]], direction[UP] = -0.68, -0.58, 0.45 * SIGN
    stack = whole(bodies)
    if flat:
        direction = axis_vector(flat[0], 1.0)
    else:
        stack = quarter_away(stack, cut_place((low, high), boxes), size)
    RenameSource("bodies, cut", stack)
    stack.UpdatePipeline(time)

    pictures = {}
    title = "%s\n%s: largest Mises stress at a node %s %s" % (TITLE, moment, short(mises.max()), STRESS)
    view = pictures["mises"] = new_view(title)
    bar = "Mises stress, nodal, " + STRESS
    draw(stack, view, "mises_nodal", bar, float(mises.max()))
    draw_plain(edges_of(stack), view, 1.0)
    look(view, middle, 0.95 * size, direction)

    # A section across the longest strip where it presses most, with the mesh.
    focus, width, along = positions[mises.argmax()], 0.01 * size, ACROSS[0]
    if boxes:
        where, values = fields[0], fields[1]("contact_pressure")
        focus = where[values.argmax()]
        width = max(min(b[1][axis] - b[0][axis] for axis in ACROSS) for b in boxes)
        own = [b for b in boxes if all(b[0] <= focus) and all(focus <= b[1])]
        along = max(ACROSS, key=lambda axis: own[0][1][axis] - own[0][0][axis]) if own else along
    if flat:
        along = flat[0]
    far_end = focus[along] > middle[along]
    section = whole(bodies)
    if not flat:
        section = Clip(registrationName="section", Input=section, ClipType="Plane")
        section.ClipType.Origin = list(focus)
        section.ClipType.Normal = axis_vector(along)
        section.Invert = 1 if far_end else 0
    view = pictures["section"] = new_view("%s\nsection where contact presses most" % TITLE)
    draw(section, view, "mises_nodal", bar, float(mises.max())).Representation = "Surface With Edges"
    near = min(max(12.0 * width, 0.02 * size), 0.3 * size)
    look(view, focus, near, axis_vector(along, 1.0 if far_end or flat else -1.0))

    if CONTACT and pressure > 0.0:
        title = "%s\n%s: largest contact pressure %s %s, drawn as height"
        view = pictures["pressure"] = new_view(title % (TITLE, moment, short(pressure), STRESS))
        hills = Clip(registrationName="pressed", Input=whole(contacts), ClipType="Scalar")
        hills.Scalars, hills.Value, hills.Invert = ["POINTS", "contact_pressure"], 1e-3 * pressure, 0
        hills = WarpByScalar(registrationName="pressure as height", Input=hills)
        hills.Scalars, hills.UseNormal, hills.Normal = ["POINTS", "contact_pressure"], 1, axis_vector(UP)
        hills.ScaleFactor = rounded(0.06 * size / pressure)
        draw(hills, view, "contact_pressure", "contact pressure, " + STRESS, pressure)
        draw_plain(edges_of(whole(bodies)), view, 0.6)
        look(view, middle, 0.95 * size, direction)

    factor = rounded(0.06 * size / displacement.max()) if displacement.max() > 0.0 else 1.0
    title = "%s\n%s: deformed shape, displacements %s times as large"
    view = pictures["deformed"] = new_view(title % (TITLE, moment, short(factor)))
    bent = WarpByVector(registrationName="deformed", Input=stack)
    bent.Vectors, bent.ScaleFactor = ["POINTS", "displacement"], factor
    draw(bent, view, "displacement", "displacement, " + LENGTH, float(displacement.max()))
    draw_plain(edges_of(stack), view, 1.0)
    look(view, middle, 0.95 * size, direction)

    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = time
    for name, view in pictures.items():
        view.ViewTime = time
        Render(view)
        if not in_window:
            file = os.path.join(here, "%s-%s.png" % (NAME, name))
            SaveScreenshot(file, view, ImageResolution=PICTURE)
            print(file)
    if in_window:
        layout = CreateLayout(NAME)
        left = layout.SplitHorizontal(0, 0.5)
        above_left = layout.SplitVertical(left, 0.5)
        above_right = layout.SplitVertical(left + 1, 0.5)
        cells = [above_left, above_right, above_left + 1, above_right + 1]
        for view, cell in zip(pictures.values(), cells):
            layout.AssignView(cell, view)


main()
