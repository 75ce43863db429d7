"""After the frames: a show's pictures on disk, made on one machine or on many."""
