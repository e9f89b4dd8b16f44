"""What stops a release, with a hint at what helps."""


class ReleaseError(Exception):
    def __init__(self, what: str, hint: str) -> None:
        super().__init__(f"error: {what}\nhint: {hint}")
