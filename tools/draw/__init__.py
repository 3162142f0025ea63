"""Draw what the book shows and no cell draws: geometry, cover, textures."""
