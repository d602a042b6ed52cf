"""The attack on the whole system: see scripts/attack."""
