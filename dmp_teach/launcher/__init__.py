"""What `python3 -m dmp_teach lab` starts, and what its Jupyter server adds."""
