"""The laws of a hand, measured in its own ink."""
