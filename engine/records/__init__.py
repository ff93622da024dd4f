"""Recorded shots: read, judged, compared, written."""
