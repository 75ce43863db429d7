"""What a recipe leaves out is not in the text; what it asks for is."""

import itertools

import pytest

from domeshim.shading.compose import compose
from domeshim.shading.draft import LEGACY_VERSION, VERSION
from domeshim.shading.recipe import ColorMaterial, Light, Lighting, Mapping, Recipe, Scene, Texture
from domeshim.shading.snippets import glsl_folder, snippet

BARE = compose(Recipe()).text


def lit(**kwargs):
    return compose(Recipe(scene=Scene(lighting=Lighting(lights=(Light(0, "directional"),), **kwargs)))).text


@pytest.mark.parametrize(
    "word",
    [
        "gl_LightSource",
        "Material",
        "normal",
        "gl_TexCoord",
        "Fog",
        "gl_ClipPlane",
        "gl_PointSize",
        "domeTilt",
        "Secondary",
    ],
)
def test_bare_scene_has_nothing_of(word):
    assert word not in BARE


def test_version_comes_first():
    assert BARE.splitlines()[0] == VERSION


def test_same_recipe_same_text():
    assert compose(Recipe()) == compose(Recipe())


def test_two_sides_only_when_asked():
    assert "gl_BackColor" not in lit()
    assert "gl_BackColor" in lit(two_sided=True)


def test_each_kind_of_light_brings_its_own_code_only():
    assert "spotCutoff" not in lit()
    assert "Attenuation" not in lit()
    spot = compose(Recipe(scene=Scene(lighting=Lighting(lights=(Light(3, "spot"),))))).text
    assert "lightSpot(3," in spot
    assert "lightDirectional" not in spot


def test_color_material_follows_the_vertex_colour():
    text = lit(color_material=ColorMaterial("front", ("ambient", "diffuse")), two_sided=True)
    assert "front.ambient = gl_Color;" in text
    assert "front.diffuse = gl_Color;" in text
    assert "back.ambient = gl_Color;" not in text


def test_texture_matrix_only_when_not_identity():
    plain, turned = (
        compose(Recipe(scene=Scene(textures=(Texture(2, matrix=m),)))).text for m in (False, True)
    )
    assert "gl_TexCoord[2] = texture2;" in plain
    assert "gl_TexCoord[2] = gl_TextureMatrix[2] * texture2;" in turned


def test_fog_is_by_distance_where_the_eye_space_is_the_viewers():
    def fog(place):
        return compose(Recipe(Mapping(place=place), Scene(fog="distance"))).text

    assert "length(eye.xyz / eye.w)" in fog("modelview")
    assert "abs(eye.z)" in fog("panel")


def test_own_clip_distances_keep_out_of_the_programs():
    for planes in ((), (0,), (0, 1, 2, 3), (4, 5)):
        for place in ("modelview", "panel"):
            recipe = Recipe(Mapping(place=place), Scene(clip_planes=planes))
            assert recipe.clip_distances
            assert not set(planes) & set(recipe.clip_distances)


def test_on_opengl_2_the_parts_of_the_clip_vertex_are_the_clip_distances():
    for mapping in every_mapping():
        for planes in ((), (0,), (2, 5)):
            text = compose(Recipe(mapping, Scene(clip_planes=planes), legacy=True)).text
            assert text.startswith(LEGACY_VERSION)
            assert "gl_ClipDistance" not in text
            assert "gl_ClipPlane[" not in text
            assert ("gl_ClipVertex = vec4(1.0);" in text) == ("gl_ClipVertex." in text)


def test_of_more_than_four_the_last_are_left_out():
    room = Recipe(Mapping(sides=(0,)), Scene(clip_planes=(0, 1)), legacy=True)
    assert room.distances == (2, 0, 1, 3)
    assert [room.distance(n) for n in (2, 0, 1, 3)] == [f"gl_ClipVertex.{part}" for part in "xyzw"]
    assert not room.left_out
    full = Recipe(Mapping(sides=(0, 2)), Scene(clip_planes=(0, 1)), legacy=True)
    assert full.distance(full.side_distances[1]) is None
    assert full.left_out
    panel = Recipe(Mapping(place="panel"), Scene(clip_planes=(1,)), legacy=True)
    assert panel.distances == (1, 0, 2, 3)
    assert panel.left_out


def test_between_opposite_sides_all_is_in_front():
    recipe = Recipe(Mapping(sides=(0, 1, 2, 3)), legacy=True)
    assert recipe.distances == recipe.side_distances
    assert not recipe.left_out
    assert "inFront(place);" not in compose(recipe).text


def test_each_line_is_traced_to_its_snippet():
    source = compose(Recipe(Mapping(aim="turned"), Scene(fog="distance", textures=(Texture(0),))))
    lines = source.text.splitlines()
    for name in ("aim/turned", "lens/equidistant", "bend/vertex", "fog/distance"):
        for number, text in enumerate(snippet(name).splitlines(), start=1):
            assert f"{name}.glsl:{number}" in [
                source.place(i + 1) for i, line in enumerate(lines) if line == text
            ]


LENSES = sorted(path.stem for path in (glsl_folder() / "lens").glob("*.glsl"))


def every_mapping():
    yield from (Mapping(lens=(f"lens/{lens}", "bend/radial")) for lens in LENSES)
    yield from (Mapping(lens=("bend/cylinder",), aim=aim, clip="wedge") for aim in ("straight", "turned"))
    for method, place, aim, clip in itertools.product(
        ("vertex", "paper"),
        ("modelview", "view", "panel"),
        ("straight", "turned", "seated"),
        ("behind", "cone"),
    ):
        yield Mapping(method, place=place, aim=aim, clip=clip)


def every_scene():
    yield Scene()
    for kind, two, local, separate in itertools.product(
        ("directional", "positional", "spot"), *[(False, True)] * 3
    ):
        yield Scene(lighting=Lighting((Light(0, kind), Light(7, kind)), two, local, separate))
    for normals in ("plain", "rescaled", "unit"):
        yield Scene(lighting=Lighting((Light(1, "spot"),)), normals=normals)
        yield Scene(
            textures=(Texture(0, ("sphere",) * 2 + (None,) * 2), Texture(1, ("normal",) * 3 + (None,))),
            normals=normals,
        )
    for face, follows in itertools.product(
        ("front", "back", "both"), (("ambient", "diffuse"), ("specular",), ("emission",))
    ):
        yield Scene(
            lighting=Lighting((Light(0, "directional"),), True, color_material=ColorMaterial(face, follows))
        )
    for generated in ("object", "eye", "reflection"):
        yield Scene(textures=(Texture(3, (generated,) * 3 + (None,), matrix=True),))
    for fog in ("distance", "attribute"):
        yield Scene(fog=fog, secondary_color=True, clip_planes=(0, 5), point_attenuation=True)
