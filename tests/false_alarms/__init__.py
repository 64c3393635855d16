"""What is no defect and must be acquitted: other determinations, documented policies, refusals, ill-conditioning."""
