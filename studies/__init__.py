"""What the designer asks: one design through the whole chain, figures, reports, and the command line."""
