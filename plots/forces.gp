# forces.gp -- forces of the fluid on every wall and beam against time
# needs: forces.csv figures/constants.gp
load 'style.gp'
table = '../forces.csv'
picture = 'forces.png'
load 'loads.gp'
