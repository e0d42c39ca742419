"""What Tamis finds, as other libraries take it; each module here needs the library that it is named after."""
