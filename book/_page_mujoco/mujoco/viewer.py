"""The window of the real package, which a page cannot open."""

raise ImportError("mujoco.viewer is not in the page's MuJoCo; run the notebook")
