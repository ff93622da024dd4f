"""The game between shots: situations, shots, the referee; values in, values out."""
