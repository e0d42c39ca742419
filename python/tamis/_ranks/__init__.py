"""What `tamis.distributed` is made of."""
