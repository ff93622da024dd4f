"""A scene graph without a word of billiards: objects, shapes, lights, camera."""
