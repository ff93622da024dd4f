"""Bringing the journal to the disk without a frame that waits."""

import os

from engine.app.syncing import Syncer


def test_every_file_is_brought_to_the_disk_in_order_and_closed(tmp_path, monkeypatch):
    done, closed = [], []
    close = os.close
    monkeypatch.setattr(
        "engine.app.syncing.os.fsync", lambda file: done.append(os.fstat(file).st_ino)
    )
    monkeypatch.setattr(
        "engine.app.syncing.os.close", lambda file: closed.append(file) or close(file)
    )
    syncer, wanted = Syncer(), []
    for number in range(5):
        with (tmp_path / str(number)).open("w") as file:
            wanted.append(os.fstat(file.fileno()).st_ino)
            syncer.sync(file.fileno())
    syncer.close()
    assert done == wanted
    assert len(closed) == 5


def test_a_disk_in_trouble_stops_nothing(tmp_path, monkeypatch):
    def broken(_file):
        raise OSError(5, "Input/output error")

    monkeypatch.setattr("engine.app.syncing.os.fsync", broken)
    syncer = Syncer()
    with (tmp_path / "one").open("w") as file:
        syncer.sync(file.fileno())
    syncer.close()


def test_closing_what_never_began_is_nothing():
    Syncer().close()
