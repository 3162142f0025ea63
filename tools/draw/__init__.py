"""Draw what the book shows and no cell draws: geometry, first screen, cover, textures."""
