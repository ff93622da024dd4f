"""What `tools.render_check` counts at length holds over a few pictures, and its counts can fail."""

import numpy as np
import pytest
from stands import TABLES, make_stage

from engine.render.renderer import RENDERERS, make_renderer
from engine.render.scanline import Scanline
from engine.variant.load import list_variants
from tools.render_check import check_all, count_hits, crumpled, differing
from tools.render_scenes import bare, draw, random_scene, variant_scene


class Mistaken:
    """A painter that leaves a stripe out."""

    def __init__(self, inner):
        self.inner = inner

    def render(self, scene, image):
        self.inner.render(scene, image)
        image[100:110] = 0


def test_every_claim_about_the_renderers_holds_over_a_few_pictures(monkeypatch):
    one = next(iter(list_variants()))
    monkeypatch.setattr("tools.render_check.list_variants", lambda: [one])
    counts = list(check_all(6))
    assert len(counts) == 11
    assert [count for count in counts if not count.holds] == []


def test_a_hole_and_a_double_hit_are_counted():
    mesh = crumpled(1)
    assert (count_hits(mesh) == 1).all()
    assert (count_hits(mesh[1:]) == 0).any()
    assert (count_hits(np.concatenate([mesh, mesh[:1]])) == 2).any()


def test_a_painter_that_errs_is_found():
    scene = random_scene(make_stage(TABLES["pockets"]()), 3)
    depth = Scanline(1, flat=True)
    assert differing(Scanline(1, flat=True), depth, scene) == 0.0
    assert differing(Mistaken(Scanline(1, flat=True)), depth, scene) > 1e-3


@pytest.mark.parametrize("variant", [one.name for one in list_variants()])
def test_a_variants_table_is_the_same_in_painters_and_with_depth(variant):
    scene = bare(variant_scene(variant))
    painted = draw(make_renderer("painter"), scene, (1280, 720))
    exact = draw(Scanline(2, flat=True, keeps=False), scene, (1280, 720))
    assert (painted != exact).mean() <= 1e-4


@pytest.mark.parametrize("name", RENDERERS)
def test_after_warming_up_no_kernel_is_compiled_any_more(name):
    import importlib
    import pkgutil

    import engine.render

    modules = [
        importlib.import_module(f"engine.render.{one.name}")
        for one in pkgutil.iter_modules(engine.render.__path__)
    ]
    kernels = [v for m in modules for v in vars(m).values() if hasattr(v, "signatures")]
    renderer = make_renderer(name)
    renderer.warm_up(None)
    before = [len(kernel.signatures) for kernel in kernels]
    stage = make_stage(TABLES["pockets"]())
    for seed in (0, 0, 0, 1):
        draw(renderer, random_scene(stage, seed))
    window = np.zeros((360, 800), np.uint32)[:, :640]
    renderer.render(stage.scene({}, random_scene(stage, 2).camera), window)
    assert [len(kernel.signatures) for kernel in kernels] == before
