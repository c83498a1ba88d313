"""Browser tests: a package, so that one Chromium serves them all and none after them."""
