"""Every subdividing variant is taken by the driver, and leaves out what is not needed."""

import pytest

from domeshim.shading.geometry import compose_geometry
from domeshim.shading.program import Program
from domeshim.shading.recipe import Light, Lighting, Mapping, Patch, Recipe, Scene, Texture
from domeshim.shading.tessellation import compose_tessellated
from tests.shading.test_compose import every_mapping, every_scene


@pytest.mark.parametrize("split", [False, True], ids=["whole", "split"])
@pytest.mark.parametrize(
    ("method", "kind"),
    [
        ("tessellate", "quads"),
        ("tessellate", "triangles"),
        ("tessellate", "lines"),
        ("geometry", "triangles"),
        ("geometry", "lines"),
    ],
)
def test_every_mapping_and_every_scene_compiles(driver, method, kind, split):
    patch = Patch(kind, method, split=split)
    recipes = {Recipe(m, patch=patch) for m in every_mapping() if m.method == "vertex"}
    recipes |= {Recipe(Mapping(place="panel"), s, patch, flat=True) for s in every_scene()}
    recipes |= {Recipe(Mapping(aim="turned"), s, patch) for s in every_scene()}
    for recipe in recipes:
        stages = compose_geometry(recipe) if method == "geometry" else compose_tessellated(recipe)
        program = Program(
            driver,
            stages.vertex,
            control=stages.control,
            evaluation=stages.evaluation,
            geometry=stages.geometry,
        )
        driver.glDeleteProgram(program.name)
    assert len(recipes) > 50
    assert driver.glGetError() == 0


BARE = Scene()


def evaluation(scene=BARE, **kwargs):
    return compose_tessellated(Recipe(Mapping(), scene, Patch("triangles"), **kwargs)).evaluation.text


def test_bare_scene_carries_a_colour_and_nothing_else():
    text = evaluation()
    assert "gl_FrontColor" in text
    for word in ("gl_TexCoord", "Fog", "gl_BackColor", "Secondary", "domeTurn"):
        assert word not in text


def test_lighting_stays_in_the_vertex_shader():
    lit = Scene(lighting=Lighting((Light(0, "spot"),)), textures=(Texture(0),))
    assert "gl_LightSource" not in evaluation(lit)
    assert "gl_LightSource" in compose_tessellated(Recipe(Mapping(), lit, Patch("triangles"))).vertex.text


def test_flat_shading_takes_the_last_vertex():
    assert "gl_FrontColor = gl_in[2].gl_FrontColor;" in evaluation(flat=True)
    assert "b.x * gl_in[0].gl_FrontColor" in evaluation()
