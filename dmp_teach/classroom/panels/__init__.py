"""The live panels of the notebooks."""
