"""Every composed variant is taken by the driver; what it refuses is said with our file and line."""

from dataclasses import replace

import pytest

from domeshim.driver import Driver
from domeshim.errors import ShaderError
from domeshim.shading.compose import compose, levels_fragment
from domeshim.shading.draft import Source
from domeshim.shading.program import Program, explain
from domeshim.shading.recipe import Mapping, Recipe
from tests.shading.test_compose import every_mapping, every_scene


@pytest.mark.parametrize("legacy", [False, True])
def test_every_mapping_and_every_scene_compiles(driver, legacy):
    recipes = {Recipe(m) for m in every_mapping()} | {Recipe(Mapping(), s) for s in every_scene()}
    recipes |= {Recipe(Mapping(place="panel", aim="turned"), s) for s in every_scene()}
    recipes |= {Recipe(Mapping(sides=(0, 1, 2, 3)), s, levels="cut") for s in every_scene()}
    for recipe in recipes:
        fragment = levels_fragment(legacy=legacy) if recipe.levels else None
        program = Program(driver, compose(replace(recipe, legacy=legacy)), fragment)
        driver.glDeleteProgram(program.name)
    assert len(recipes) > 100
    assert driver.glGetError() == 0


def test_refused_shader_is_quoted_with_file_and_line(driver):
    broken = Source.join(
        [
            ("lens/y", "// fine\n"),
            ("lens/x", "float f() {\n    return nothing;\n}\n"),
            ("main", "void main() {}"),
        ]
    )
    with pytest.raises(ShaderError, match=r"lens/x\.glsl:2.*nothing"):
        Program(driver, broken)


def test_places_of_other_drivers_are_named_too():
    source = Source.join([("lens/x", "a;\n" * 20), ("main", "void main() {}")])
    assert explain("0(13) : error C1008: undefined", source) == "lens/x.glsl:12 : error C1008: undefined"
    assert explain("0:22(1): error: x", source) == "main.glsl:1(1): error: x"


def test_missing_entry_point_names_itself():
    with pytest.raises(AttributeError, match="glNoSuchThing"):
        Driver().glNoSuchThing()
