"""lapfx for Python: bleeding and surgical smoke as numpy arrays. One file over the C API (lapfx.h).

    import lapfx

    pictures = lapfx.render("lagb.scene.json", "tuned.json", times=[0, 2, 4], size=(640, 512), clip_folders=["clips"])
    pictures.shape  # (3, 512, 640, 3), uint8, rows from the top
    # clips of presets that came with lapfx: clip_folders=[".../share/lapfx/samples/clips"]

Many pictures of one scene, with one value after another:

    with lapfx.Player("lagb.scene.json", "tuned.json", clip_folders=["clips"]) as player:
        player.preset["bleeding.speed"] = 8
        player.effects.set_preset(player.preset)
        picture, area = player.picture(6.0), player.effects.amounts().blood_area

Call by call: samples/host/host.py (share/lapfx). Lengths mm, times s, colours as in lapfx.h. What fails raises Error:
BadInput (a file or a value has to change), NoOpenGL, Misuse (the program has to change), or Error itself. Warnings go
to the logger "lapfx". Objects are freed when they are collected, at the end of `with`, or by close(); contexts, effects
and frames on the thread that made them.

The library is LAPFX_LIBRARY, else that which was installed with this file, else what the loader finds.
"""
import atexit
import ctypes
import glob
import json
import logging
import os

import numpy

__all__ = ["ACTIONS", "Amounts", "BadInput", "Contact", "Context", "Effects", "Error", "Frame", "Misuse", "NoOpenGL", "Organ",
           "Player", "Preset", "Response", "Sample", "Scene", "View", "bleeding_shader", "post_shader", "post_values",
           "render", "version"]

ACTIONS = ("cauterise", "cut", "coagulate", "tear", "suction", "irrigation", "clip")
WOUND_STATES = ("waiting", "bleeding", "spent", "clotting", "closed")
BACKENDS = ("automatic", "egl", "osmesa")


class Error(RuntimeError):
    """A call of lapfx failed; the text says what was found and what is allowed."""


class BadInput(Error, ValueError):
    """A file or a value has to change."""


class NoOpenGL(Error):
    """No usable OpenGL on this machine."""


class Misuse(Error):
    """The program has to change: the order of calls, a thread, an object that was closed."""


_ERRORS = {1: Error, 2: BadInput, 3: NoOpenGL, 4: Misuse}


def _open():
    name = "liblapfx.so.0.1"  # a library of another version may have other structs
    prefix = glob.escape(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", ".."))
    beside = [path for where in ("lib", "lib/*", "lib64") for path in glob.glob(os.path.join(prefix, where, name))]
    path = os.environ.get("LAPFX_LIBRARY") or (beside[0] if beside else name)
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"lapfx: {error}; LAPFX_LIBRARY may name the library") from error
    library.lapfx_version.restype = library.lapfx_last_message.restype = ctypes.c_char_p
    found = library.lapfx_version().decode()
    if not found.startswith("0.1."):
        raise ImportError(f"lapfx: {path} is version {found}; this file is of 0.1")
    return library


_library = _open()
_LOG = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p)
_FUNCTIONS = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_char_p)


@_LOG
def _log(_user, level, message):
    if level == 1:  # what failed is raised
        logging.getLogger("lapfx").warning("%s", message.decode(errors="replace"))


_library.lapfx_set_log(_log, None)
atexit.register(_library.lapfx_set_log, None, None)  # what is collected later has no logger


def _call(name, *arguments):
    status = getattr(_library, "lapfx_" + name)(*arguments)
    if status:
        raise _ERRORS[status](_library.lapfx_last_message().decode(errors="replace"))


def _fill(kind, name, *arguments):
    """Calls that fill what their last argument leads to."""
    out = kind()
    _call(name, *arguments, ctypes.byref(out))
    return out


def _get(kind, name, *arguments):
    return _fill(kind, name, *arguments).value


def _text(path):
    return None if path is None else os.fsencode(path)


def _exactly(kind, name, values):
    """An array of ctypes, which would take fewer numbers, too."""
    if len(values) != kind._length_:
        raise BadInput(f"{name}: {len(values)} numbers; expected {kind._length_}")
    return kind(*values)


def _index(name, value, words):
    if value not in words:
        raise BadInput(f"{name}: {value} is not one of {', '.join(words)}")
    return words.index(value)


def _floats(values, width, name, rows=None):
    """An array of vertices, with so many rows; None stays None."""
    if values is None:
        return None
    array = numpy.ascontiguousarray(values, numpy.float32)
    if array.ndim != 2 or array.shape[1] != width or rows not in (None, len(array)):
        raise BadInput(f"{name}: an array of the shape {array.shape}; expected ({rows or 'vertices'}, {width})")
    return array


def _pointer(array):
    return None if array is None else array.ctypes.data


def version():
    """The version of the library, as "0.1.0"."""
    return _library.lapfx_version().decode()


def bleeding_shader():
    """The text that gives an organ shader of your own its blood (lapfx/effects.h)."""
    return _get(ctypes.c_char_p, "bleeding_shader").decode()


def post_shader():
    """The text that makes the camera's picture of a frame that you finish yourself (lapfx/camera.h)."""
    return _get(ctypes.c_char_p, "post_shader").decode()


def post_values(response, width, height):
    """What the uniform array lapfx_camera of post_shader() is set to: (4, 4)."""
    values = (ctypes.c_float * 16)()
    _call("post_values", ctypes.byref(response), width, height, values)
    return numpy.array(values, numpy.float32).reshape(4, 4)


class _Struct(ctypes.Structure):
    """A struct that begins with its size; arguments that are not given have their defaults."""

    defaults = {}

    def __init__(self, **values):
        kinds, values = {field[0]: field[1] for field in self._fields_}, {**self.defaults, **values}
        if isinstance(values.get("action"), str):
            values["action"] = _index("action", values["action"], ACTIONS)
        for name, value in values.items():
            if name not in kinds:
                raise TypeError(f"{type(self).__name__} has no {name}; it has: {', '.join(kinds)}")
            if hasattr(kinds[name], "_length_"):
                values[name] = _exactly(kinds[name], name, value)
        super().__init__(size=ctypes.sizeof(type(self)), **values)

    def __repr__(self):
        values = ((field[0], getattr(self, field[0])) for field in self._fields_[1:])
        shown = (f"{name}={list(value) if hasattr(value, '__len__') else value!r}" for name, value in values)
        return f"{type(self).__name__}({', '.join(shown)})"


_double, _size, _int, _chars, _address = ctypes.c_double, ctypes.c_size_t, ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p
_double3, _float16 = ctypes.c_double * 3, ctypes.c_float * 16
_IDENTITY = tuple(numpy.eye(4).ravel())


class Contact(_Struct):
    """The tool touches the organ from `time` for `duration`, its tip moving straight from `position` to `to`."""
    _fields_ = [("size", _size), ("action", _int), ("time", _double), ("duration", _double), ("position", _double3),
                ("to", _double3), ("power", _double), ("strength", _double)]
    defaults = {"duration": 1.0, "power": 1.0, "strength": 1.0}


class Sample(_Struct):
    """Where the tip is at one moment and what it does there."""
    _fields_ = [("size", _size), ("time", _double), ("position", _double3), ("touching", _int), ("action", _int),
                ("power", _double), ("strength", _double)]
    defaults = {"power": 1.0, "strength": 1.0}


class View(_Struct):
    """Where a frame is seen from, and the lamp. Matrices are column by column: View.of takes them as numpy has them."""
    _fields_ = [("size", _size), ("view", _float16), ("projection", _float16), ("lamp_intensity", _double),
                ("lamp_focus_distance", _double), ("lamp_beam_angle", _double), ("lamp_ambient", _double),
                ("lamp_color", _double3), ("haze", _int)]
    defaults = {"view": _IDENTITY, "projection": _IDENTITY, "lamp_intensity": 1.0, "lamp_focus_distance": 100.0,
                "lamp_beam_angle": 75.0, "lamp_ambient": 0.02, "lamp_color": (1.0, 1.0, 1.0), "haze": 1}

    @classmethod
    def of(cls, view, projection, **lamp):
        """From two arrays (4, 4) that are multiplied with columns: `projection @ view @ point`."""
        return cls(view=numpy.asarray(view).ravel("F"), projection=numpy.asarray(projection).ravel("F"), **lamp)


class Response(_Struct):
    """How light becomes a picture."""
    _fields_ = [("size", _size), ("exposure", _double), ("vignette", _double), ("white_balance", _double3),
                ("sharpening", _double), ("saturation", _double), ("lens_falloff", _double), ("curve", _int),
                ("toe", _double), ("knee", _double), ("white", _double)]
    defaults = {"exposure": 1.0, "vignette": 1.0, "white_balance": (1.0, 1.0, 1.0), "sharpening": 0.0,
                "saturation": 1.0, "lens_falloff": 0.45, "curve": 0, "toe": 0.2, "knee": 0.6, "white": 3.0}


class Amounts(_Struct):
    """How much blood and smoke there is: mm2, mm3; see lapfx.h."""
    _fields_ = [("size", _size), ("blood_area", _double), ("blood_volume", _double), ("burnt_area", _double),
                ("haze", _double), ("emission", _double), ("lost_samples", ctypes.c_uint64), ("wounds", _int),
                ("bleeding_wounds", _int), ("left_out_wounds", _int)]


class Wound(_Struct):
    """A place that bleeds; `state` is an index into WOUND_STATES."""
    _fields_ = [("size", _size), ("state", _int), ("bleeds", _int), ("position", _double3), ("start", _double),
                ("stop", _double), ("strength", _double), ("extent", _double)]


class Hit(_Struct):
    """A point on the organ under a ray."""
    _fields_ = [("size", _size), ("found", _int), ("position", _double3), ("distance", _double)]


class MemoryUse(_Struct):
    """Bytes, by purpose."""
    _fields_ = [(name, _size) for name in ("size", "surface", "pixels", "densities", "geometry", "textures", "clips",
                                           "targets", "total")]


class SceneInfo(_Struct):
    """What a scene says of itself; texts are bytes."""
    _fields_ = [("size", _size), ("name", _chars), ("preset", _chars), ("duration", _double),
                ("seed", ctypes.c_uint32), ("gravity", _double3), ("organ_file", _chars), ("organ_scale", _double),
                ("organ_rotation", _double3), ("organ_texture", _chars), ("organ_color", _double3),
                ("eye", _double3), ("target", _double3), ("up", _double3), ("field_of_view", _double),
                ("exposure", _double), ("vignette", _double), ("lamp_intensity", _double),
                ("lamp_focus_distance", _double), ("lamp_beam_angle", _double), ("lamp_color", _double3),
                ("event_count", _size)]


class _OrganOptions(_Struct):
    _fields_ = [("size", _size), ("scale", _double), ("rotation", _double3), ("texture", _chars)]


class _Mesh(_Struct):
    _fields_ = [("size", _size), ("vertex_count", _size), ("positions", _address), ("index_count", _size),
                ("indices", _address), ("normals", _address), ("uvs", _address), ("colors", _address)]


class _OrganData(_Struct):
    _fields_ = [("size", _size), ("vertex_count", _size), ("index_count", _size),
                *((name, ctypes.POINTER(ctypes.c_float)) for name in ("positions", "normals", "uvs", "colors")),
                ("indices", ctypes.POINTER(ctypes.c_uint32))]


class _EffectsOptions(_Struct):
    _fields_ = [("size", _size), ("seed", ctypes.c_uint32), ("gravity", _double3),
                ("clip_folders", ctypes.POINTER(_chars)), ("clip_folder_count", _size), ("wait_for_clips", _int),
                ("clip_memory", _size)]


class _Object:
    _kind, _handle = "", ctypes.c_void_p(1)  # once closed: no handle of lapfx's, where None may mean that there is none

    def _made(self, name, *arguments):
        self._handle = ctypes.c_void_p(_get(ctypes.c_void_p, name, *arguments))
        return self

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Frees it; later calls raise Misuse. Closing again does nothing."""
        if "_handle" in vars(self):
            _call(self._kind + "_destroy", self._handle)
            del self._handle

    def __del__(self):
        try:
            self.close()
        except Error:  # collected on another thread, or without the host's context: it stays
            pass


class Context(_Object):
    """OpenGL without a window. `backend`: automatic, egl or osmesa."""

    _kind = "context"

    def __init__(self, backend="automatic"):
        self._made("context_create", _index("backend", backend, BACKENDS))

    @classmethod
    def external(cls, get_proc_address):
        """The window's context, current; `get_proc_address` gives the address of a function by its name, bytes."""
        context = cls.__new__(cls)
        context._functions = _FUNCTIONS(get_proc_address)
        return context._made("context_external", context._functions)

    def renderer(self):
        """GL_RENDERER."""
        return _get(ctypes.c_char_p, "context_renderer", self._handle).decode(errors="replace")

    def make_current(self):
        """Before OpenGL calls of your own."""
        _call("context_make_current", self._handle)


class Organ(_Object):
    """A triangle mesh with textures, from a file. Arrays are copies, a row for each vertex or triangle."""

    _kind = "organ"

    def __init__(self, path, scale=0.0, rotation=(0.0, 0.0, 0.0), texture=None):
        options = _OrganOptions(scale=scale, rotation=rotation, texture=_text(texture))
        self._made("organ_load", _text(path), ctypes.byref(options))

    @classmethod
    def of(cls, positions, triangles, normals=None, uvs=None, colors=None):
        """From arrays: (n, 3) mm, (m, 3) indices, and what there is of (n, 3), (n, 2), (n, 4)."""
        positions, indices = _floats(positions, 3, "positions"), numpy.ascontiguousarray(triangles, numpy.uint32)
        rows = len(positions)
        normals, uvs = _floats(normals, 3, "normals", rows), _floats(uvs, 2, "uvs", rows)
        colors = _floats(colors, 4, "colors", rows)
        mesh = _Mesh(vertex_count=rows, positions=_pointer(positions), index_count=indices.size, indices=_pointer(indices),
                     normals=_pointer(normals), uvs=_pointer(uvs), colors=_pointer(colors))
        return cls.__new__(cls)._made("organ_create", ctypes.byref(mesh))

    def refined(self):
        """The organ with triangles fine enough for blood, for those who draw it themselves."""
        return Organ.__new__(Organ)._made("organ_refine", self._handle)

    def prepare(self, preset=None):
        """Does now, on any thread, what makes Effects(...) take long."""
        _call("organ_prepare", self._handle, preset and preset._handle)

    def _array(self, name, width):
        data = _fill(_OrganData, "organ_get_data", self._handle)
        rows = data.index_count // 3 if name == "indices" else data.vertex_count
        return numpy.ctypeslib.as_array(getattr(data, name), (rows, width)).copy()

    positions = property(lambda self: self._array("positions", 3), doc="(n, 3) mm")
    normals = property(lambda self: self._array("normals", 3), doc="(n, 3) unit")
    uvs = property(lambda self: self._array("uvs", 2), doc="(n, 2)")
    colors = property(lambda self: self._array("colors", 4), doc="(n, 4) linear RGBA")
    triangles = property(lambda self: self._array("indices", 3), doc="(m, 3) indices")


class Preset(_Object):
    """How blood and smoke look, from a file: preset["bleeding.speed"] = 8. Keys: presets/REFERENCE.md."""

    _kind = "preset"

    def __init__(self, path):
        self._made("preset_load", _text(path))

    @classmethod
    def parse(cls, text, folder=None):
        """From JSON; `folder` is where its clips are looked up first."""
        return cls.__new__(cls)._made("preset_parse", text.encode(), _text(folder))

    def json(self):
        """All of it, as JSON."""
        return _get(ctypes.c_char_p, "preset_write", self._handle).decode()

    def __setitem__(self, key, value):
        if isinstance(value, (bool, numpy.bool_)):
            value = "true" if value else "false"
        elif hasattr(value, "__len__") and not isinstance(value, str):
            value = ",".join(str(float(one)) for one in value)
        _call("preset_set", self._handle, key.encode(), str(value).encode())

    def __getitem__(self, key):
        value = json.loads(self.json())
        for word in key.split("."):
            value = value[int(word)] if isinstance(value, list) else value[word]
        return value


class Scene(_Object):
    """Organ, camera, light and tool events to show a preset on, from a file."""

    _kind = "scene"

    def __init__(self, path):
        self._made("scene_load", _text(path))

    def info(self):
        """Its values (SceneInfo)."""
        info = _fill(SceneInfo, "scene_get_info", self._handle)
        info._scene = self  # its texts are the scene's
        return info

    def events(self):
        """What the tool does, in the order of time: a list of Contact."""
        return [_fill(Contact, "scene_get_event", self._handle, _size(i)) for i in range(self.info().event_count)]

    def view(self, width, height):
        """Its camera and lamp, for a frame of so many pixels."""
        return _fill(View, "scene_get_view", self._handle, width, height)

    def response(self):
        """How its frames become pictures."""
        return _fill(Response, "scene_get_response", self._handle)

    def load_organ(self):
        """Its organ, with its scale, rotation and texture."""
        return Organ.__new__(Organ)._made("scene_load_organ", self._handle)


class Effects(_Object):
    """Blood and smoke of one organ."""

    _kind = "effects"

    def __init__(self, context, organ, preset, seed=1, gravity=(0.0, -1.0, 0.0), clip_folders=(), wait_for_clips=False,
                 clip_memory=1 << 30):
        folders = (_chars * len(clip_folders))(*map(_text, clip_folders))
        options = _EffectsOptions(seed=seed, gravity=gravity, clip_folders=folders, clip_folder_count=len(folders),
                                  wait_for_clips=wait_for_clips, clip_memory=clip_memory)
        self._made("effects_create", context._handle, organ._handle, preset._handle, ctypes.byref(options))

    def set_preset(self, preset):
        """The next frame shows it."""
        _call("effects_set_preset", self._handle, preset._handle)

    def set_contacts(self, contacts):
        """All contacts so far, past and running."""
        _call("effects_set_contacts", self._handle, (Contact * len(contacts))(*contacts), _size(len(contacts)))

    def set_organ(self, organ, contacts=()):
        """Another organ, which was prepared, with all that has happened to it; no frame takes long for it."""
        _call("effects_set_organ", self._handle, organ._handle, (Contact * len(contacts))(*contacts), _size(len(contacts)))

    def organ_coming(self):
        """Whether the organ of set_organ is still on its way; seek() shows it."""
        return bool(_get(_int, "effects_get_organ_coming", self._handle))

    def push_sample(self, sample):
        """May be called on one other thread."""
        _call("effects_push_sample", self._handle, ctypes.byref(sample))

    def set_curves(self, scene):
        """The factors over time of a scene; None: none."""
        _call("effects_set_curves", self._handle, scene and scene._handle)

    def set_shape(self, positions, normals=None):
        """Deforms the organ: a row for each vertex that it was given with."""
        positions = _floats(positions, 3, "positions")
        normals = _floats(normals, 3, "normals", len(positions))
        _call("effects_set_shape", self._handle, _size(len(positions)), ctypes.c_void_p(_pointer(positions)),
              ctypes.c_void_p(_pointer(normals)))

    def set_gravity(self, gravity):
        """Blood runs this way."""
        _call("effects_set_gravity", self._handle, _exactly(_double3, "gravity", gravity))

    def set_seed(self, seed):
        """Every random choice depends on it alone."""
        _call("effects_set_seed", self._handle, ctypes.c_uint32(seed))

    def set_organ_color(self, color):
        """Multiplies the colours of the organ; sRGB."""
        _call("effects_set_organ_color", self._handle, _exactly(_double3, "color", color))

    def seek(self, time):
        """The state at a time, s."""
        _call("effects_seek", self._handle, _double(time))

    def draw_organ(self, view):
        """Into the bound framebuffer."""
        _call("effects_draw_organ", self._handle, ctypes.byref(view))

    def draw_metal_clips(self, view):
        """For those who draw the organ themselves."""
        _call("effects_draw_metal_clips", self._handle, ctypes.byref(view))

    def draw_smoke(self, view, depth):
        """Over the frame; `depth` is its depth texture."""
        _call("effects_draw_smoke", self._handle, ctypes.byref(view), ctypes.c_uint(depth))

    def bleed_buffer(self):
        """The OpenGL buffer that an organ shader of your own reads."""
        return _get(ctypes.c_uint, "effects_bleed_buffer", self._handle)

    def bind_bleeding(self):
        """Binds its uniform block, at binding 1."""
        _call("effects_bind_bleeding", self._handle)

    def amounts(self):
        """Amounts at the last seek."""
        return _fill(Amounts, "effects_get_amounts", self._handle)

    def wounds(self):
        """A list of Wound, as at the last seek."""
        count = _get(_size, "effects_get_wound_count", self._handle)
        return [_fill(Wound, "effects_get_wound", self._handle, _size(i)) for i in range(count)]

    def contacts(self):
        """What has happened so far: a list of Contact."""
        count = _get(_size, "effects_get_contact_count", self._handle)
        return [_fill(Contact, "effects_get_contact", self._handle, _size(i)) for i in range(count)]

    def pick(self, origin, direction):
        """Where a ray first meets the organ (Hit), or None."""
        hit = _fill(Hit, "effects_pick", self._handle, _exactly(_double3, "origin", origin),
                    _exactly(_double3, "direction", direction))
        return hit if hit.found else None

    def late(self):
        """Whether the last smoke showed an older frame of a clip than was due."""
        return bool(_get(_int, "effects_get_late", self._handle))

    def memory(self):
        """Bytes, by purpose."""
        return _fill(MemoryUse, "effects_get_memory", self._handle)


class Frame(_Object):
    """The editor's frame: begin, draw, begin_smoke, draw the smoke, read."""

    _kind = "frame"
    _size = (0, 0)

    def __init__(self, context):
        self._made("frame_create", context._handle)

    def begin(self, width, height):
        """Bound and cleared."""
        _call("frame_begin", self._handle, width, height)
        self._size = (width, height)

    def begin_smoke(self):
        """When all tissue and instruments are drawn."""
        _call("frame_begin_smoke", self._handle)

    def depth(self):
        """The depth texture for Effects.draw_smoke."""
        return _get(ctypes.c_uint, "frame_get_depth", self._handle)

    def finish(self, framebuffer=0, response=None):
        """Writes the picture into a framebuffer; 0 is the window's."""
        _call("frame_finish", self._handle, ctypes.c_uint(framebuffer), ctypes.byref(response or Response()))

    def read(self, response=None, out=None):
        """The picture: (height, width, 4) uint8, rows from the top; into `out` where it is given."""
        if out is None:
            out = numpy.empty((self._size[1], self._size[0], 4), numpy.uint8)
        elif out.dtype != numpy.uint8 or not out.flags.c_contiguous or not out.flags.writeable:
            raise BadInput(f"out: an array of {out.dtype}; expected one of uint8, without gaps, that may be written")
        _call("frame_read", self._handle, ctypes.byref(response or Response()), ctypes.c_void_p(out.ctypes.data),
              _size(out.nbytes))
        return out


class Player:
    """A scene with a preset (a path, a Preset, or None: the scene's own), as pictures: those of `lapfx render`, without
    the instrument. What it is made of may be used: scene, preset, context, organ, effects, frame."""
    __enter__, __exit__ = _Object.__enter__, _Object.__exit__  # and no __del__: what it is made of may outlive it

    def __init__(self, scene, preset=None, size=(640, 512), clip_folders=(), backend="automatic", seed=None):
        self.scene = scene if isinstance(scene, Scene) else Scene(scene)
        info = self.scene.info()
        self.preset = preset if isinstance(preset, Preset) else Preset(info.preset if preset is None else preset)
        self.size, self.context = size, Context(backend)
        self.organ = self.scene.load_organ()
        self.effects = Effects(self.context, self.organ, self.preset, seed=info.seed if seed is None else seed,
                               gravity=info.gravity, clip_folders=clip_folders, wait_for_clips=True)
        self.effects.set_organ_color(info.organ_color)
        self.effects.set_curves(self.scene)
        self.effects.set_contacts(self.scene.events())
        self.frame = Frame(self.context)

    def picture(self, time):
        """The picture at a time, s, in any order: (height, width, 4) uint8."""
        view = self.scene.view(*self.size)
        self.effects.seek(time)
        self.frame.begin(*self.size)
        self.effects.draw_organ(view)
        self.frame.begin_smoke()
        self.effects.draw_smoke(view, self.frame.depth())
        return self.frame.read(self.scene.response())

    def close(self):
        """Frees what belongs to its context; again does nothing."""
        for one in (self.frame, self.effects, self.context):
            one.close()


def render(scene, preset=None, times=(0.0,), size=(640, 512), clip_folders=(), backend="automatic", alpha=False):
    """Pictures of a scene with a preset at `times`: (times, height, width, 3) uint8, with `alpha` 4."""
    with Player(scene, preset, size, clip_folders, backend) as player:
        pictures = [player.picture(time)[..., :4 if alpha else 3] for time in times]
    return numpy.stack(pictures) if pictures else numpy.empty((0, size[1], size[0], 4 if alpha else 3), numpy.uint8)
