"""What stands on the disk and what is run are what the page shows; texts with errors are neither, and a reload costs no drawing."""

from test_studio import FIELD, browser, studio  # noqa: F401

CONTROL = 2
NOTICE = "([...document.querySelectorAll('.notice')].map((one) => one.innerText).join(' '))"


def type_into(studio, name, text):  # noqa: F811
    """Types into the field of a number, and stays in it."""
    studio.wait(FIELD % repr(name))
    studio.browser.evaluate(f"(({FIELD % repr(name)}).querySelector('input').focus(), true)")
    studio.browser.evaluate(f"(({FIELD % repr(name)}).querySelector('input').select(), true)")
    studio.browser.call("Input.insertText", text=text)


def model_of(studio):  # noqa: F811
    return (studio.folder / "four-bar/model.toml").read_text()


def test_a_number_without_its_unit_keeps_the_one_that_stood_there(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    for typed, line in [("81", 'crank_length = "81 mm"'), ("80,5", 'crank_length = "80.5 mm"'), ("0.0802 m", 'crank_length = "0.0802 m"')]:
        studio.type_number("crank_length", typed)
        assert line in studio.saved("four-bar")[0], typed
    assert studio.browser.diagnostics() == []


def test_a_comma_that_may_separate_thousands_is_not_guessed_at(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = model_of(studio)
    studio.type_number("crank_length", "80,500")
    studio.wait("document.querySelector('.field.wrong')")
    studio.click("button:not(.primary)", "Save")
    studio.wait(f"{NOTICE}.includes('Not saved, because the texts have an error')")
    assert model_of(studio) == before


def test_broken_texts_are_neither_saved_nor_run(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = model_of(studio)
    type_into(studio, "crank_length", "80 mn")
    # The number is typed and not yet taken over: it belongs to what is shown all the same.
    studio.click("button", "Save and run")
    studio.wait(f"{NOTICE}.includes('Not saved, because the texts have an error')")
    studio.wait("document.querySelector('.problems').innerText.includes(\"'mn' is not a known unit\")")
    assert model_of(studio) == before
    assert studio.browser.evaluate("document.querySelectorAll('.jobs li, .job').length") == 0
    assert not (studio.folder / "results").exists()
    # Somebody who goes home may still save what is not finished.
    studio.click("button", "Save with the error")
    studio.wait("document.querySelector('.bar').innerText.includes('· saved')")
    assert 'crank_length = "80 mn"' in model_of(studio)


def test_what_is_being_typed_is_saved(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    type_into(studio, "crank_length", "83 mm")
    for kind in ("rawKeyDown", "keyUp"):
        studio.browser.call("Input.dispatchKeyEvent", type=kind, key="s", code="KeyS", windowsVirtualKeyCode=83, modifiers=CONTROL)
    studio.wait("document.querySelector('.bar').innerText.includes('· saved')")
    assert 'crank_length = "83 mm"' in model_of(studio)
