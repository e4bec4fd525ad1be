// A precompiled header is made only for a target with a source that takes it.
