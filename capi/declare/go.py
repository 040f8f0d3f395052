def files(description): return {}
