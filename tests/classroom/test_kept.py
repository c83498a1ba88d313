"""What outlives the running of a cell."""

from hypothesis import given
from hypothesis import strategies as st

from dmp_teach.classroom.panels.kept import forget, kept


@given(st.text(), st.text(), st.dictionaries(st.text(), st.integers(), min_size=1))
def test_a_key_keeps_what_it_was_given_until_it_is_forgotten(key, other, content):
    forget(key)
    kept(other)
    held = kept(key)
    held.update(content)
    assert kept(key) == content
    assert key == other or kept(other) is not kept(key)
    forget(key)
    assert held == kept(key) == {}
