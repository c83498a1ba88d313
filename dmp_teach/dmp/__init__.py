"""The primitive: phase, kernels, fit, settings and rollout."""
