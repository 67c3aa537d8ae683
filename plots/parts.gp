# parts.gp -- forces of the fluid on the panels of a scene against time
# needs: panels.csv figures/constants.gp
load 'style.gp'
table = '../panels.csv'
picture = 'parts.png'
load 'loads.gp'
