"""Other ways to learn a movement that the paper names, beside DMP*."""
