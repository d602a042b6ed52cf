"""The fuzzing of the parsers: see scripts/fuzz."""
