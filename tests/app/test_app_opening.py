"""A game is opened with the grammar of scripts kept from run to run."""

from engine.app.opening import open_variant
from rulelang.tables import FILE


def test_the_grammar_is_kept_in_the_users_folder(tmp_path, monkeypatch):
    monkeypatch.setattr("engine.app.opening.user_cache_path", lambda _name: tmp_path / "kept")
    assert open_variant("killer").name == "killer"
    assert (tmp_path / "kept" / FILE).is_file()


def test_only_this_module_loads_games_for_the_window():
    from pathlib import Path

    import engine.app

    folder = Path(engine.app.__file__).parent
    loading = [one.name for one in folder.glob("*.py") if "load_variant" in one.read_text("utf-8")]
    assert loading == ["opening.py"]
