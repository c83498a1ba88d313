"""One test of a law that holds for many cases, such as every letter of our alphabets."""


def for_every(cases):
    """Make one test of a law of one case; it names every case for which the law does not hold."""

    cases = list(cases)

    def make_test(law):
        def test():
            failed = {}
            for case in cases:
                try:
                    law(*case)
                except AssertionError as error:
                    failed[case] = str(error)
            assert failed == {}

        test.__name__, test.__doc__ = law.__name__, law.__doc__
        return test

    return make_test
