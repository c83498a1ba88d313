"""Names of an older version still work, with a warning that names the new one."""

import pytest

import dmp_teach as teach
from dmp_teach import studies

OLD = {
    "error_against_width": "sweep_kernel_width",
    "p_from_d": "make_p_from_d",
    "told_apart": "classify_writers",
    "Bench": "Evidence",
}


@pytest.mark.parametrize("old", OLD)
def test_an_old_name_of_a_study_is_the_new_one_with_a_warning(old):
    with pytest.warns(DeprecationWarning, match=f"studies.{old} is now called .*{OLD[old]}"):
        assert getattr(studies, old) is getattr(studies, OLD[old])


@pytest.mark.parametrize(("old", "new"), [("word", "write_word"), ("ProgressBar", "progress_bar")])
def test_an_old_name_of_the_package_is_the_new_one_with_a_warning(old, new):
    with pytest.warns(DeprecationWarning, match=f"{old} is now called dmp_teach.{new}"):
        assert getattr(teach, old) is getattr(teach, new)
