"""JupyterLab as `python3 -m dmp_teach lab` starts it, and what its server adds."""
