"""What no key of the data can say: `check = "name a b"` calls name(test, "a", "b"), after the call of the step."""
