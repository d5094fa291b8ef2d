"""Bad inputs by the thousand: good files, what is done to them, the commands that are given them, and how those end."""
