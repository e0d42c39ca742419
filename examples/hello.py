import numpy as np
import tamis

faces = [[0, 1, 2], [3, 4, 5]]  # two triangles; the second one's corner 3 falls
start = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1], [1, 0.5, 2], [0.5, 1, 2]])
end = start.copy()
end[3] = [0.25, 0.25, -1]
detector = tamis.Detector(tamis.Mesh(faces))
for contact in detector.contacts(start, end):
    print(f"vertex {contact.vertices[0]} meets the face in [{contact.toi_lower:.6f}, {contact.toi_upper:.6f}]")
