"""Files that are too long to be written into the data: `make = {"file" = "name 1 2"}` calls name(1, 2)."""
